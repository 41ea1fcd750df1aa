// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md: velocity Verlet whose forces take the velocity predicted for the boundary, v + h a of the
// last one. Held beside it is that in the middle of the step, from which the step goes on.
INLINE void kick_middle(World w, int i, Motion* m) {
  const real half_step = w.constants->time.y;
  const real3 before = m->velocity;
  kick(m, w.accelerations[i].xyz * half_step);
  book(w, i, half_step, (before + m->velocity) * (real)0.5);
}

INLINE void integrate(World w, int i, int step) {
  Motion m = motion_in(w.middles, w.rests, i);
  if (!(m.inverse_mass > 0)) return;
  if (step > 1) kick_middle(w, i, &m);
  take_kick(w, i, &m);
  kick_middle(w, i, &m);
  turn_over(w, i, turn_middle(w, i, step));
  keep_motion(w.middles, w.rests, i, m);
  w.velocities[i] = (real4)(m.velocity + w.accelerations[i].xyz * w.constants->time.y, m.inverse_mass);
  take_shift(w, i);
  drop_corrections(w, i);
  drift_body(w, i, m.velocity, w.constants->time.z, step);
}

INLINE real3 at_boundary(World w, Motion m, real3 acceleration, int step) {
  if (step > 0 && m.inverse_mass > 0) kick(&m, acceleration * w.constants->time.y);
  return m.velocity;
}
