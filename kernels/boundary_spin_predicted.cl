// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void report_spin(World w, int i, int step, global real4* seen, int entry) {
  Motion m = motion_in(w.spin_middles, w.spin_rests, i);
  if (step > 0 && m.inverse_mass > 0) kick(&m, w.angular_accelerations[i].xyz * w.constants->time.y);
  take_spin_kick(w, i, &m);
  seen[entry] = (real4)(m.velocity, 0);
}
