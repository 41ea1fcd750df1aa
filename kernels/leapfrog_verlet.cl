// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Sweetman 2.19: velocities stand half a step behind the positions.
INLINE void integrate(World w, int i, int step) {
  const real duration = step > 1 ? w.constants->time.x : w.constants->time.y;
  Motion m = load_motion(w, i);
  if (!(m.inverse_mass > 0)) return;
  const real3 before = m.velocity;
  kick(&m, w.accelerations[i].xyz * duration);
  book(w, i, duration, (before + m.velocity) * (real)0.5);
  spin_up(w, i, duration);
  turn_over(w, i, spin_of(w, i));
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
