// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE bool reaches_farther() { return false; }
INLINE Reach reach_of(World w, int i, Position p) { return radius_of(p); }
INLINE real attraction(real reach_overlap, PairLaw law) { return 0; }
INLINE real cohesive_energy(real reach_overlap, PairLaw law) { return 0; }
