// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md, velocity_verlet_implicit: at every boundary first the springs, whose forces foretell the
// velocities that dashpots take, then everything. Springs are stretched in the first stage, with the velocities in the
// middle of the step, and cut back in the second.
#define STAGES 2
#define MOVES_LAST 0

INLINE bool springs_only(World w) { return w.stage == 0; }
INLINE real stretch_time(World w, int step) { return step > 0 && springs_only(w) ? w.constants->time.x : 0; }
