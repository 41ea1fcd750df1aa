// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md. The velocities held are those in the middle of the step, with which forces are taken.
INLINE void integrate(World w, int i, int step) {
  const real half_step = w.constants->time.y;
  Motion m = load_motion(w, i);
  if (!(m.inverse_mass > 0)) return;
  const real3 change = w.accelerations[i].xyz * half_step;
  if (step > 1) {
    book(w, i, half_step, m.velocity);
    kick(&m, change);
    spin_up(w, i, half_step);
  }
  kick(&m, change);
  spin_up(w, i, half_step);
  book(w, i, half_step, m.velocity);
  store_motion(w, i, m);
  drift_body(w, i, m.velocity, w.constants->time.z, step);
}

INLINE real3 at_boundary(World w, Motion m, real3 acceleration, int step) {
  if (step > 0 && m.inverse_mass > 0) kick(&m, acceleration * w.constants->time.y);
  return m.velocity;
}
