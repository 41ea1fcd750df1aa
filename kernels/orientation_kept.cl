// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What rounding leaves out of a change is kept and added with the next one, as for velocities: slow turns are small
// beside the last digit of a quaternion. So is what it leaves out of the step and of spin times step: of a steady spin
// that is the same at every step, and would add up to a last digit of the whole angle.
INLINE void turn_over(World w, int i, real3 spin) {
  const real step = w.constants->time.x;
  const real4 q = w.orientations[i], rest = w.orientation_rests[i];
  const real3 turn = spin * step;
  const real3 left = fma(spin, (real3)(step), -turn) + spin * w.constants->limits.z;
  const real4 y = change_of(q, rest, turn, left) + rest;
  const real4 sum = q + y;
  const real4 seen = sum - q;
  w.orientation_rests[i] = (q - (sum - seen)) + (y - seen);
  w.orientations[i] = sum;
}

INLINE void report_orientation(World w, int i, global real4* seen, int entry) { seen[entry] = w.orientations[i]; }
