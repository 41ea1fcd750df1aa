// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// No contact remembers anything.
typedef struct {
  real3 slip, normal;
  real pressing, root_mass, duration, share;
} Strain;

INLINE global real4* spring_of_pair(World w, int slot) { return 0; }
INLINE global real4* spring_of_wall(World w, int i, int wall) { return 0; }
INLINE void stretch_spring(real3* rubbing, global real4* spring, Strain s, PairLaw law, Rise rise, Account* account) {}
INLINE void release_spring(global real4* spring, real share, real duration, Account* account) {}
