// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A velocity change, added as it is.
typedef struct {
  real3 velocity;
  real inverse_mass;
} Motion;

INLINE Motion load_motion(World w, int i) {
  const real4 v = w.velocities[i];
  Motion m = {v.xyz, v.w};
  return m;
}

INLINE void store_motion(World w, int i, Motion m) { w.velocities[i] = (real4)(m.velocity, m.inverse_mass); }

INLINE void kick(Motion* m, real3 change) { m->velocity += change; }

INLINE void set_velocity(Motion* m, real3 velocity) { m->velocity = velocity; }
