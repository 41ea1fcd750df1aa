// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 velocity_at_boundary(World w, int i, int step) {
  Motion m = motion_in(w.middles, w.rests, i);
  if (step > 0 && m.inverse_mass > 0) kick(&m, w.accelerations[i].xyz * w.constants->time.y);
  take_kick(w, i, &m);
  return m.velocity;
}
