// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What a body gets at a boundary besides its force, from contacts that began or ended on the way there: changes of
// velocity (w: 1 where there is anything), of place (over the step) and of spin. The force stage writes them down, the
// next move or whoever looks takes them.
#define CORRECTION_WORDS 3

typedef struct {
  real3 kick;   // N s
  real3 shift;  // N s²
  real3 twist;  // N m s
  real events;
} Correction;

INLINE Correction no_correction() {
  Correction c = {(real3)(0), (real3)(0), (real3)(0), 0};
  return c;
}

INLINE void close_correction(World w, Body self, Correction c) {
  if (!(c.events > 0)) return;
  global real4* kept = w.corrections + CORRECTION_WORDS * self.index;
  kept[0] = (real4)(c.kick * self.inverse_mass, 1);
  kept[1] = (real4)(c.shift * (self.inverse_mass / w.constants->time.x), 1);
  kept[2] = (real4)(c.twist * inverse_inertia_of(w, self.index), 0);
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
