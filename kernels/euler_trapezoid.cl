// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md: explicit velocity, position by the trapezoid of old and new velocity.
INLINE void integrate(World w, int i, int step) {
  Motion m = load_motion(w, i);
  if (!(m.inverse_mass > 0)) return;
  const real3 before = m.velocity, spin_before = spin_of(w, i);
  kick(&m, w.accelerations[i].xyz * w.constants->time.x);
  const real3 twice_mean = before + m.velocity;
  book(w, i, w.constants->time.x, twice_mean * (real)0.5);
  spin_up(w, i, w.constants->time.x);
  turn_over(w, i, (spin_before + spin_of(w, i)) * (real)0.5);
  store_motion(w, i, m);
  drift_body(w, i, twice_mean, w.constants->time.w, step);
}

INLINE real3 at_boundary(World w, Motion m, real3 acceleration, int step) { return m.velocity; }
