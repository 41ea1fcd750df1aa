// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Forces are evaluated once a step, all together.
#define STAGES 1
#define MOVES_LAST 0

INLINE bool springs_only(World w) { return false; }
INLINE real stretch_time(World w, int step) { return step > 0 ? w.constants->time.x : 0; }
