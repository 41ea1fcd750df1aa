// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md. The velocities held are those in the middle of the step, with which forces are taken.
INLINE void kick_by_half(World w, int i, Motion* m) {
  const real half_step = w.constants->time.y;
  const real3 before = m->velocity;
  kick(m, w.accelerations[i].xyz * half_step);
  book(w, i, half_step, (before + m->velocity) * (real)0.5);
  spin_up(w, i, half_step);
}

INLINE void integrate(World w, int i, int step) {
  Motion m = load_motion(w, i);
  if (!(m.inverse_mass > 0)) return;
  if (step > 1) {
    kick_by_half(w, i, &m);
  }
  kick_by_half(w, i, &m);
  turn_over(w, i, spin_of(w, i));
  store_motion(w, i, m);
  drift_body(w, i, m.velocity, w.constants->time.z, step);
}

INLINE real3 at_boundary(World w, Motion m, real3 acceleration, int step) {
  if (step > 0 && m.inverse_mass > 0) kick(&m, acceleration * w.constants->time.y);
  return m.velocity;
}
