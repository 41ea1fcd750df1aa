// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What rounding leaves out of a change is kept and added with the next one, as for velocities: slow turns are small
// beside the last digit of a quaternion.
INLINE void turn_over(World w, int i, real3 spin) {
  const real4 q = w.orientations[i];
  const real4 y = change_of(q, spin * w.constants->time.x) + w.orientation_rests[i];
  const real4 sum = q + y;
  const real4 seen = sum - q;
  w.orientation_rests[i] = (q - (sum - seen)) + (y - seen);
  w.orientations[i] = sum;
}

INLINE void report_orientation(World w, int i, global real4* seen, int entry) { seen[entry] = w.orientations[i]; }
