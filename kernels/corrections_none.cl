// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What a contact does in a step is in the force at its end alone.
typedef struct {
  char nothing;
} Correction;

INLINE Correction no_correction() {
  Correction c = {0};
  return c;
}
INLINE void close_correction(World w, Body self, Correction c) {}
INLINE void take_kick(World w, int i, Motion* m) {}
INLINE void take_spin_kick(World w, int i, Motion* m) {}
INLINE void take_shift(World w, int i) {}
INLINE void drop_corrections(World w, int i) {}
INLINE Position position_at_boundary(World w, int i) { return w.positions[i]; }
