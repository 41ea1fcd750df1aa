// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What a body gets at a boundary besides its force, from contacts that began or ended on the way there: changes of
// velocity (w: 1 where there is anything), of place (over the step) and of spin. The force stage writes them down, the
// next move or whoever looks takes them.
#define CORRECTION_WORDS 3

// Impulse, moment of it and twist on a body, from one contact. Added in memory: few steps have any, and every contact
// would pay for sums that are carried along.
INLINE void enter_correction(World w, int i, real3 impulse, real3 moment, real3 twist) {
  global real4* kept = w.corrections + CORRECTION_WORDS * i;
  const real inverse_mass = w.velocities[i].w;
  kept[0] += (real4)(impulse * inverse_mass, 1);
  kept[1] += (real4)(moment * (inverse_mass / w.constants->time.x), 1);
  kept[2] += (real4)(twist * inverse_inertia_of(w, i), 0);
}

INLINE void take_kick(World w, int i, Motion* m) {
  const real4 change = w.corrections[CORRECTION_WORDS * i];
  if (change.w > 0) kick(m, change.xyz);
}

INLINE void take_spin_kick(World w, int i, Motion* m) {
  const global real4* kept = w.corrections + CORRECTION_WORDS * i;
  if (kept[0].w > 0) kick(m, kept[2].xyz);
}

INLINE Position position_at_boundary(World w, int i) {
  Position p = w.positions[i];
  const real4 shift = w.corrections[CORRECTION_WORDS * i + 1];
  if (shift.w > 0 && displace(&p, shift.xyz, w.constants->time.z)) wrap(&p, w.box);
  return p;
}

// Once no other body looks at this one.
INLINE void take_shift(World w, int i) {
  global real4* kept = w.corrections + CORRECTION_WORDS * i;
  if (!(kept[1].w > 0)) return;
  w.positions[i] = position_at_boundary(w, i);
  kept[1] = (real4)(0);
}

INLINE void drop_corrections(World w, int i) {
  global real4* kept = w.corrections + CORRECTION_WORDS * i;
  if (kept[0].w > 0) kept[0] = kept[2] = (real4)(0);
}
