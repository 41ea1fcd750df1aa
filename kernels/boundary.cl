// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 velocity_at_boundary(World w, int i, int step) {
  return at_boundary(w, load_motion(w, i), w.accelerations[i].xyz, step);
}
