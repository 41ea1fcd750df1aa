// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The first of two evaluations of forces in a step of a zoned scene, and what it foretells; kernels/steps.cl has the
// second. None of them runs with a list that has gone stale.
kernel void resolve_springs(WORLD_PARAMETERS, const global int* pair_starts, const global int* partners,
                            const int step) {
  const World w = WORLD;
  if (!forces_halt(w, step)) gather_forces(w, get_global_id(0), pair_starts, partners, step);
}

kernel void foresee_velocities(WORLD_PARAMETERS, const int step) {
  World w = WORLD;
  const int i = get_global_id(0);
  w.stage = 1;
  if (step > 0 && !forces_halt(w, step) && w.velocities[i].w > 0) integrate(w, i, step);
}
