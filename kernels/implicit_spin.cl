// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Spins as velocities, kernels/velocity_verlet_implicit.cl.
INLINE void kick_middle_spin(World w, int i, Motion* m) {
  const real half_step = w.constants->time.y;
  const real3 before = m->velocity;
  kick(m, w.angular_accelerations[i].xyz * half_step);
  book_spin(w, i, half_step, (before + m->velocity) * (real)0.5);
}

// To the middle of the step.
INLINE real3 advance_spin(World w, int i, int step) {
  Motion m = motion_in(w.spin_middles, w.spin_rests, i);
  if (step > 1) kick_middle_spin(w, i, &m);
  kick_middle_spin(w, i, &m);
  keep_motion(w.spin_middles, w.spin_rests, i, m);
  w.spins[i] = (real4)(m.velocity, m.inverse_mass);
  return m.velocity;
}

INLINE void foresee_spin(World w, int i) {
  const real4 middle = w.spin_middles[i];
  w.spins[i] = (real4)(middle.xyz + w.angular_accelerations[i].xyz * w.constants->time.y, middle.w);
}
