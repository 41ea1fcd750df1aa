// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Eight particles at a time, in double precision: wide_single_16.cl, with phases in units of 2^-64 of the cell.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define LANES 8
#define GROUP 8
#define KNOWN global
#define PHASE_BITS 64
typedef double8 reals;
typedef long8 phases;
typedef long8 flags;
typedef int8 indices;
typedef uint8 coarses;
typedef float8 floats;
typedef long phase;
typedef ulong bare_phase;
typedef long4 phase4;

typedef struct {
  reals x, y, z, w;
} Quarter;

INLINE reals load_reals(const global real* from) { return vload8(0, from); }
INLINE void store_reals(global real* to, reals values) { vstore8(values, 0, to); }
INLINE phases load_phases(const global phase* from) { return vload8(0, from); }
INLINE indices load_indices(const global int* from) { return vload8(0, from); }
INLINE indices load_entries(const global uint* from) { return as_int8(vload8(0, from)); }
INLINE coarses load_coarses(const global uint* from) { return vload8(0, from); }
INLINE floats load_floats(const global float* from) { return vload8(0, from); }
INLINE floats metres_between(coarses a, uint b) { return convert_float8(as_int8(a - b)); }
INLINE phases phases_of(reals bits) { return as_long8(bits); }
INLINE reals bits_of_phases(phases p) { return as_double8(p); }
INLINE phase4 phase4_of(real4 bits) { return as_long4(bits); }
INLINE reals to_reals(phases p) { return convert_double8(p); }
INLINE reals roots_of(reals x) { return sqrt(x); }
INLINE reals magnitudes(reals x) { return as_double8(as_long8(x) & 0x7fffffffffffffffl); }
INLINE flags different(indices a, indices b) { return convert_long8(a != b); }
INLINE indices lanes_from(int first) { return first + (int8)(0, 1, 2, 3, 4, 5, 6, 7); }
INLINE flags below(indices a, int b) { return convert_long8(a < b); }

// 32 yes or no for every particle, and particles that are meant.
typedef uint8 masks;
INLINE masks as_masks(int8 f) { return as_uint8(f); }
INLINE flags as_marks(masks m) { return convert_long8(m); }
INLINE void store_masks(private uint* to, masks m) { vstore8(m, 0, to); }
INLINE masks masks_of_lanes(int from, int to) {
  const int8 lanes = (int8)(0, 1, 2, 3, 4, 5, 6, 7);
  return as_uint8((lanes >= from) & (lanes < to));
}

INLINE bool any_of(flags f) {
  const long4 c = f.lo | f.hi;
  const long2 d = c.lo | c.hi;
  return (d.x | d.y) != 0;
}
INLINE int bits_of(flags f) {
  const long8 bits = f & (long8)(1, 2, 4, 8, 16, 32, 64, 128);
  const long4 c = bits.lo | bits.hi;
  const long2 d = c.lo | c.hi;
  return (int)(d.x | d.y);
}

// Two by two in place of all at once: every line is one instruction.
INLINE Quarter transposed(double8 a, double8 b, double8 c, double8 d) {
#define LOW(a, b) (double8)(a.s0, b.s0, a.s2, b.s2, a.s4, b.s4, a.s6, b.s6)
#define HIGH(a, b) (double8)(a.s1, b.s1, a.s3, b.s3, a.s5, b.s5, a.s7, b.s7)
  const double8 e = LOW(a, b), f = LOW(c, d), g = HIGH(a, b), h = HIGH(c, d);
  Quarter q;
  q.x = (double8)(e.s01, f.s01, e.s45, f.s45);
  q.y = (double8)(g.s01, h.s01, g.s45, h.s45);
  q.z = (double8)(e.s23, f.s23, e.s67, f.s67);
  q.w = (double8)(g.s23, h.s23, g.s67, h.s67);
  return q;
}

// A list says where a record is in units of eight bytes, which an address can be scaled by for nothing.
#define UNITS_A_RECORD (QUARTERS * 4)
#define RECORD_OF(k) *(const global real4*)(units + entry[k])
INLINE Quarter fetch(const global real4* records, const global uint* entry, int quarter) {
  const global ulong* units = (const global ulong*)(records + quarter);
  return transposed((double8)(RECORD_OF(0), RECORD_OF(4)), (double8)(RECORD_OF(1), RECORD_OF(5)),
                    (double8)(RECORD_OF(2), RECORD_OF(6)), (double8)(RECORD_OF(3), RECORD_OF(7)));
}

// As wide_single_16.cl; more than a pair of quarters is two lines of the cache, wherever it begins.
#define ASK(k) fetch_ahead(units + entry[k])
#define ASK_FOR_ALL ASK(0), ASK(1), ASK(2), ASK(3), ASK(4), ASK(5), ASK(6), ASK(7)
INLINE void ask_for(const global real4* records, const global uint* entry) {
  const global ulong* units = (const global ulong*)records;
  ASK_FOR_ALL;
  if (QUARTERS <= 2) return;
  units += 8;
  ASK_FOR_ALL;
}

#define OWN_RECORD(k) records[(first + k) * QUARTERS + quarter]
INLINE Quarter fetch_own(const global real4* records, int first, int quarter) {
  return transposed((double8)(OWN_RECORD(0), OWN_RECORD(4)), (double8)(OWN_RECORD(1), OWN_RECORD(5)),
                    (double8)(OWN_RECORD(2), OWN_RECORD(6)), (double8)(OWN_RECORD(3), OWN_RECORD(7)));
}

INLINE void store_own(global real4* records, int first, int quarter, Quarter q) {
  const Quarter t = transposed(q.x, q.y, q.z, q.w);
  OWN_RECORD(0) = t.x.s0123;
  OWN_RECORD(1) = t.y.s0123;
  OWN_RECORD(2) = t.z.s0123;
  OWN_RECORD(3) = t.w.s0123;
  OWN_RECORD(4) = t.x.s4567;
  OWN_RECORD(5) = t.y.s4567;
  OWN_RECORD(6) = t.z.s4567;
  OWN_RECORD(7) = t.w.s4567;
}

// σ² − r²: differences of phases are exact, and what is rounded is some 1e-16 of either.
INLINE reals square_gap(phases x, phases y, phases z, double4 quantum, double8 sum) {
  const double8 a = convert_double8(x) * quantum.x, b = convert_double8(y) * quantum.y,
                c = convert_double8(z) * quantum.z;
  return fma(sum, sum, -fma(a, a, fma(b, b, c * c)));
}
typedef double8 lengths;
INLINE lengths length_in(phases p, double unit) { return convert_double8(p) * unit; }
INLINE reals rounded(lengths l) { return l; }
INLINE lengths exact_phases(phases p) { return convert_double8(as_ulong8(p)); }
INLINE lengths exact_indices(indices i) { return convert_double8(i); }
INLINE lengths cells_entered(phases now, phases then) {
  const phases moved = now - then;
  const phases next = (moved >= 0) & (as_ulong8(now) < as_ulong8(then));
  const phases last = (moved < 0) & (as_ulong8(now) > as_ulong8(then));
  return convert_double8(last - next);  // yes is −1
}

// Nothing is kept: a unit is far below what rounding leaves of a place elsewhere.
#define KEPT 0
INLINE phases displaced(phases p, global real* part, reals move) { return p + convert_long8(move); }
INLINE phases displaced_roughly(phases p, reals move) { return p + convert_long8(move); }
INLINE phases kick_and_move(phases p, reals* velocity, global real* part, global real* rest, reals change, real drift,
                            flags moves) {
  *velocity = moves ? *velocity + change : *velocity;
  return p + convert_long8(moves ? *velocity * drift : 0);
}

INLINE flags flags_of(long8 f) { return f; }

// Two words a sum, so that its unit is below the last digit of any force: dense_sum_canonical.cl.
#define FINER 0x1p32
typedef long8 wholes;
INLINE wholes to_wholes(reals x) { return convert_long8(x); }
INLINE reals from_wholes(wholes w) { return convert_double8(w); }
