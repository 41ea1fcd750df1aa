// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md: velocity Verlet whose dashpots act with the velocity that they leave. Held is the velocity in
// the middle of the step, and beside it what forces take: that same one for the springs, then what these foretell.
INLINE void kick_middle(World w, int i, Motion* m) {
  const real half_step = w.constants->time.y;
  const real3 before = m->velocity;
  kick(m, w.accelerations[i].xyz * half_step);
  book(w, i, half_step, (before + m->velocity) * (real)0.5);
}

INLINE void foresee(World w, int i) {
  const real4 middle = w.middles[i];
  w.velocities[i] = (real4)(middle.xyz + w.accelerations[i].xyz * w.constants->time.y, middle.w);
  foresee_spin(w, i);
}

INLINE void integrate(World w, int i, int step) {
  Motion m = motion_in(w.middles, w.rests, i);
  if (!(m.inverse_mass > 0)) return;
  if (w.stage > 0) {
    foresee(w, i);
    return;
  }
  if (step > 1) kick_middle(w, i, &m);
  kick_middle(w, i, &m);
  turn_over(w, i, advance_spin(w, i, step));
  keep_motion(w.middles, w.rests, i, m);
  w.velocities[i] = (real4)(m.velocity, m.inverse_mass);
  drift_body(w, i, m.velocity, w.constants->time.z, step);
}

INLINE real3 at_boundary(World w, Motion m, real3 acceleration, int step) {
  if (step > 0 && m.inverse_mass > 0) kick(&m, acceleration * w.constants->time.y);
  return m.velocity;
}
