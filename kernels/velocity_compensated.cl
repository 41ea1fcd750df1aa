// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A velocity change whose rounding is kept and added with the next one (Knuth's two-sum). Without it a float
// loses up to half a last digit a step, always the same way under constant gravity.
typedef struct {
  real3 velocity;
  real3 rest;
  real inverse_mass;
} Motion;

INLINE Motion motion_in(const global real4* rates, const global real4* rests, int i) {
  const real4 v = rates[i];
  Motion m = {v.xyz, rests[i].xyz, v.w};
  return m;
}

INLINE void keep_motion(global real4* rates, global real4* rests, int i, Motion m) {
  rates[i] = (real4)(m.velocity, m.inverse_mass);
  rests[i] = (real4)(m.rest, 0);
}

INLINE Motion load_motion(World w, int i) { return motion_in(w.velocities, w.rests, i); }
INLINE void store_motion(World w, int i, Motion m) { keep_motion(w.velocities, w.rests, i, m); }

INLINE void kick(Motion* m, real3 change) {
  const real3 y = change + m->rest;
  const real3 sum = m->velocity + y;
  const real3 seen = sum - m->velocity;
  m->rest = (m->velocity - (sum - seen)) + (y - seen);
  m->velocity = sum;
}

INLINE void set_velocity(Motion* m, real3 velocity) {
  m->velocity = velocity;
  m->rest = (real3)(0);
}
