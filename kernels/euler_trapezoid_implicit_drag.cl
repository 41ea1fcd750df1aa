// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md: v' = (v + h a + (h/τ) u_f)/(1 + h/τ), written as a change of v so that
// nothing is lost where h/τ is small.
INLINE void integrate(World w, int i, int step) {
  const real whole = w.constants->time.x;
  Motion m = load_motion(w, i);
  if (!(m.inverse_mass > 0)) return;
  const real3 before = m.velocity, spin_before = spin_of(w, i);
  const real rate = drag_rate(w, i);
  const real3 stream = flow_at(w, w.positions[i]);
  const real3 wanted = w.accelerations[i].xyz + (stream - before) * rate;
  kick(&m, wanted * (whole / (1 + whole * rate)));
  const real3 twice_mean = before + m.velocity;
  book(w, i, whole, twice_mean * (real)0.5);
  book_drag(w, i, whole, (stream - m.velocity) * rate, twice_mean * (real)0.5);
  spin_up(w, i, whole);
  turn_over(w, i, (spin_before + spin_of(w, i)) * (real)0.5);
  store_motion(w, i, m);
  drift_body(w, i, twice_mean, w.constants->time.w, step);
}

INLINE real3 at_boundary(World w, Motion m, real3 acceleration, int step) { return m.velocity; }
