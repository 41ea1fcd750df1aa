// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Forces take velocities predicted for the boundary, but what moves bodies, and so stretches a spring, is the velocity
// in the middle of the step. None has led to the first boundary. Spheres that roll round each other have another normal
// there, which is the one that tells slip from approach.
INLINE real3 flat_against(real3 v, real3 normal) {
  return v - (v.x * normal.x + v.y * normal.y + v.z * normal.z) * normal;
}

INLINE real3 stretching_slip(World w, ContactPoint c, real3 slip) {
  if (c.starting) return slip;
  const real3 velocity = w.middles[c.self].xyz - (c.other >= 0 ? w.middles[c.other].xyz : c.surface);
  real3 normal = c.normal;
  if (c.other >= 0) normal -= flat_against(velocity, c.normal) * (w.constants->time.y / c.apart);
  const real3 rolling = rolling_in(w.spin_middles, c.self, c.arm, c.other, c.other_arm, normal);
  return flat_against(flat_against(velocity - rolling, normal), c.normal);
}
INLINE real3 winding_spin(World w, int i) { return middle_spin_of(w, i); }
