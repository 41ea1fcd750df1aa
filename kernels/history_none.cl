// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// No contact remembers anything.
typedef struct {
  real3 moved, damped, normal;
  real pressing, overlap, root_mass, share;
  Turnover turnover;
  Turn turn;
} Strain;

INLINE global real4* memory_of_pair(World w, int slot) { return 0; }
INLINE global real4* memory_of_wall(World w, int slot) { return 0; }
INLINE real spring_damping_of(PairLaw law, real root_mass, Rise rise) { return 0; }
INLINE void stretch_spring(real3* rubbing, global real4* memory, Strain s, PairLaw law, Rise rise, Account* account) {}
INLINE void forget(global real4* memory) {}
