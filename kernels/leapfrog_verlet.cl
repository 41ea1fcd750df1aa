// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Sweetman 2.19: velocities stand half a step behind the positions.
INLINE void integrate(World w, int i, int step) {
  const real whole = w.constants->time.x, half_step = w.constants->time.y;
  Motion m = load_motion(w, i);
  if (!(m.inverse_mass > 0)) return;
  const real3 acceleration = w.accelerations[i].xyz;
  if (step > 1) {
    book(w, i, half_step, m.velocity);
    kick(&m, acceleration * whole);
  } else {
    kick(&m, acceleration * half_step);
  }
  book(w, i, half_step, m.velocity);
  spin_up(w, i, step > 1 ? whole : half_step);
  store_motion(w, i, m);
  drift_body(w, i, m.velocity, w.constants->time.z, step);
}

// The mean of the velocities half a step before and half a step after.
INLINE real3 at_boundary(World w, Motion m, real3 acceleration, int step) {
  if (step == 0 || !(m.inverse_mass > 0)) return m.velocity;
  Motion next = m;
  kick(&next, acceleration * w.constants->time.x);
  return (m.velocity + next.velocity) * (real)0.5;
}
