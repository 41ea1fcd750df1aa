// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The whole of a small scene in one work-group: many steps in one launch, all pairs, partners in increasing id.
INLINE void resolve_all_pairs(World w, int i, int step) {
  const Body self = load_body(w, i);
  if (!(self.inverse_mass > 0)) return;
  const int particles = w.constants->counts.x, row = i * get_global_size(0);
  Load load = no_load();
  for (int j = 0; j < particles; ++j)
    if (j != i) meet_sphere(w, &load, self, j, row + j, step);
  finish_forces(w, load, self, step);
}

INLINE void record(World w, int i, int step, int slot, global Position* seen_positions, global real4* seen_velocities,
                   global real4* seen_spins, global real4* seen_orientations) {
  const int entry = slot * get_global_size(0) + i;
  seen_positions[entry] = position_at_boundary(w, i);
  seen_velocities[entry] = (real4)(velocity_at_boundary(w, i, step), 0);
  report_spin(w, i, step, seen_spins, entry);
  report_orientation(w, i, seen_orientations, entry);
}

// From step `first` to step `last`, writing down what is there at the steps in `sample_steps`, which increase; those
// before `next_sample` are behind. The forces of step 0 are taken where `set_up` says so.
kernel void run_small(WORLD_PARAMETERS, const int set_up, const int first, const int last,
                      const global int* sample_steps, const int samples, const int next_sample,
                      global Position* seen_positions, global real4* seen_velocities, global real4* seen_spins,
                      global real4* seen_orientations) {
  World w = WORLD;
  const int i = get_global_id(0);
  int next = next_sample;
  for (w.stage = 0; set_up && w.stage < STAGES; ++w.stage) resolve_all_pairs(w, i, 0);
  barrier(CLK_GLOBAL_MEM_FENCE);
  for (int step = first + 1; step <= last; ++step) {
    for (w.stage = 0; w.stage < STAGES; ++w.stage) {
      if (w.stage > 0) barrier(CLK_GLOBAL_MEM_FENCE);
      if (!movers_halt(w, step)) integrate(w, i, step);
      barrier(CLK_GLOBAL_MEM_FENCE);
      if (!forces_halt(w, step)) {
        resolve_all_pairs(w, i, step);
      } else if (i == 0) {
        w.signals[HALTED] = 1;
      }
    }
    if (MOVES_LAST) {
      barrier(CLK_GLOBAL_MEM_FENCE);
      if (!movers_halt(w, step)) complete(w, i, step);
    }
    if (next < samples && sample_steps[next] == step)
      record(w, i, step, next++, seen_positions, seen_velocities, seen_spins, seen_orientations);
    barrier(CLK_GLOBAL_MEM_FENCE);
  }
  w.reported[i] = (real4)(velocity_at_boundary(w, i, last), 0);
  report_spin(w, i, last, w.reported_spins, i);
  take_shift(w, i);
}
