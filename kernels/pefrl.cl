// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md: a drift a stage, after the kick of the stage before; the shares are in stages_composed.cl.
INLINE void kick_then_drift(World w, int i, int stage, int step) {
  Motion m = load_motion(w, i);
  if (!(m.inverse_mass > 0)) return;
  if (stage > 0) {
    const real duration = w.constants->time.x * kick_share(stage - 1);
    kick(&m, w.accelerations[i].xyz * duration);
    spin_up(w, i, duration);
  }
  turn_over(w, i, spin_of(w, i) * drift_share(stage));
  store_motion(w, i, m);
  drift_body(w, i, m.velocity, w.constants->time.z * drift_share(stage), step);
}

INLINE void integrate(World w, int i, int step) { kick_then_drift(w, i, w.stage, step); }

INLINE void complete(World w, int i, int step) { kick_then_drift(w, i, STAGES, step); }

INLINE real3 at_boundary(World w, Motion m, real3 acceleration, int step) { return m.velocity; }
