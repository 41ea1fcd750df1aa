// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A velocity change, added as it is.
typedef struct {
  real3 velocity;
  real inverse_mass;
} Motion;

INLINE Motion motion_in(const global real4* rates, const global real4* rests, int i) {
  const real4 v = rates[i];
  Motion m = {v.xyz, v.w};
  return m;
}

INLINE void keep_motion(global real4* rates, global real4* rests, int i, Motion m) {
  rates[i] = (real4)(m.velocity, m.inverse_mass);
}

INLINE Motion load_motion(World w, int i) { return motion_in(w.velocities, w.rests, i); }
INLINE void store_motion(World w, int i, Motion m) { keep_motion(w.velocities, w.rests, i, m); }

INLINE void kick(Motion* m, real3 change) { m->velocity += change; }

INLINE void set_velocity(Motion* m, real3 velocity) { m->velocity = velocity; }
