// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What a contact does in a step is in the force at its end alone.
INLINE void take_kick(World w, int i, Motion* m) {}
INLINE void take_spin_kick(World w, int i, Motion* m) {}
INLINE void take_shift(World w, int i) {}
INLINE void drop_corrections(World w, int i) {}
INLINE Position position_at_boundary(World w, int i) { return w.positions[i]; }
