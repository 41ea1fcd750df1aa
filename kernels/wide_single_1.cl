// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// One particle at a time, in single precision: phases as in wide_single_16.cl, the rest in wide_1.cl.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define PHASE_BITS 32
typedef int phase;
typedef uint bare_phase;
typedef int4 phase4;

INLINE bare_phase phases_of(real bits) { return as_uint(bits); }
INLINE real bits_of_phases(bare_phase p) { return as_float(p); }
INLINE phase4 phase4_of(real4 bits) { return as_int4(bits); }

// What is left of a position below a unit, and what rounding left out of a velocity.
#define KEPT 6

INLINE bare_phase displaced(bare_phase p, global real* part, real move) {
  const int leap = (int)move;
  const real left = *part + (move - (real)leap);
  const int more = (int)left;
  *part = left - (real)more;
  return p + (uint)leap + (uint)more;
}

// To within a unit, for those that only look.
INLINE bare_phase displaced_roughly(bare_phase p, real move) { return p + (uint)(int)move; }

// Kicks a velocity along an axis and moves with it, losing nothing: docs/precision.md.
INLINE bare_phase kick_and_move(bare_phase p, real* velocity, global real* part, global real* rest, real change,
                                real drift, int moves) {
  const real left_out = *rest;
  const real y = change + left_out, sum = *velocity + y, seen = sum - *velocity;
  *rest = moves ? (*velocity - (sum - seen)) + (y - seen) : left_out;
  *velocity = moves ? sum : *velocity;
  return displaced(p, part, moves ? sum * drift : 0);
}
