// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void report_spin(World w, int i, int step, global real4* seen, int entry) {
  const Motion spin = motion_in(w.spins, w.spin_rests, i);
  seen[entry] = (real4)(at_boundary(w, spin, w.angular_accelerations[i].xyz, step), 0);
}
