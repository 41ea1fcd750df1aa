// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Contacts without springs that remember only that they are there: the fourth component is above 0 then.
typedef struct {
  real3 moved, damped, normal;
  real pressing, overlap, root_mass, share;
  Turnover turnover;
  Turn turn;
} Strain;

INLINE global real4* memory_of_pair(World w, int slot) { return w.springs + slot * MEMORY_WORDS; }
INLINE global real4* memory_of_wall(World w, int slot) { return w.wall_springs + slot * MEMORY_WORDS; }
INLINE real spring_damping_of(PairLaw law, real root_mass, Rise rise) { return 0; }
INLINE void stretch_spring(real3* rubbing, global real4* memory, Strain s, PairLaw law, Rise rise, Account* account) {}
INLINE void forget(global real4* memory) {
  if (memory->w != 0) *memory = (real4)(0);
}
INLINE real3 remembered_spring(const global real4* memory, real3 normal, PairLaw law) { return (real3)(0); }
INLINE real3 left_of(real3 damped, real stiffness, real limit, PairLaw law) { return (real3)(0); }
INLINE real3 gripping(real3 spring, real3 damped, real stiffness, real limit, PairLaw law) { return (real3)(0); }
