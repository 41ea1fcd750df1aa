// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// One step of a zoned scene is one launch of `move` and one of `resolve`; which of them must not run
// any more, the signals say, without the host.
INLINE bool moved_too_far(World w, int i, const global Position* built_at) {
  return !within(separation(built_at[i], w.positions[i], w.box), w.box->half_skin);
}

// From the boundary before `step` to the one after.
kernel void move(WORLD_PARAMETERS, const global Position* built_at, const int step) {
  const World w = WORLD;
  const int i = get_global_id(0);
  if (movers_halt(w, step) || !(w.velocities[i].w > 0)) return;
  integrate(w, i, step);
  if (moved_too_far(w, i, built_at)) atomic_min(&w.signals[STALE_AT], step);
}

INLINE void gather_forces(World w, int i, const global int* pair_starts, const global int* partners, int step) {
  const Body self = load_body(w, i);
  if (!(self.inverse_mass > 0)) return;
  Load load = no_load();
  for (int k = pair_starts[i]; k < pair_starts[i + 1]; ++k) meet_sphere(w, &load, self, partners[k], k, step);
  finish_forces(w, load, self, step);
}

// Forces at the boundary after `step`: each particle gathers from its partners, so nothing is written twice.
kernel void resolve(WORLD_PARAMETERS, const global int* pair_starts, const global int* partners, const int step) {
  World w = WORLD;
  const int i = get_global_id(0);
  w.stage = STAGES - 1;
  if (!forces_halt(w, step))
    gather_forces(w, i, pair_starts, partners, step);
  else if (i == 0)
    w.signals[HALTED] = 1;
}

kernel void report(WORLD_PARAMETERS, const int step) {
  const World w = WORLD;
  const int i = get_global_id(0);
  w.reported[i] = (real4)(velocity_at_boundary(w, i, step), 0);
  report_spin(w, i, step, w.reported_spins, i);
  take_shift(w, i);
}
