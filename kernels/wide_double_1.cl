// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// One particle at a time, in double precision: phases as in wide_double_8.cl, the rest in wide_1.cl.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define PHASE_BITS 64
typedef long phase;
typedef ulong bare_phase;
typedef long4 phase4;

INLINE bare_phase phases_of(real bits) { return as_ulong(bits); }
INLINE real bits_of_phases(bare_phase p) { return as_double(p); }
INLINE phase4 phase4_of(real4 bits) { return as_long4(bits); }

// Nothing is kept: a unit is far below what rounding leaves of a place elsewhere.
#define KEPT 0
INLINE bare_phase displaced(bare_phase p, global real* part, real move) { return p + (ulong)(long)move; }
INLINE bare_phase displaced_roughly(bare_phase p, real move) { return p + (ulong)(long)move; }
INLINE bare_phase kick_and_move(bare_phase p, real* velocity, global real* part, global real* rest, real change,
                                real drift, int moves) {
  *velocity = moves ? *velocity + change : *velocity;
  return p + (ulong)(long)(moves ? *velocity * drift : 0);
}

// Two words a sum, so that its unit is below the last digit of any force: dense_sum_canonical.cl.
#define FINER 0x1p32
