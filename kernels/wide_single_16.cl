// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Sixteen particles at a time, in single precision. A phase is where a centre lies within its cell, in units of
// 2^-32 of the cell: differences of near ones are exact, and wrap by themselves.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define LANES 16
#define GROUP 16
#define KNOWN global
#define PHASE_BITS 32
typedef float16 reals;
typedef int16 phases;
typedef int16 flags;
typedef int16 indices;
typedef uint16 coarses;
typedef float16 floats;
typedef int phase;
typedef uint bare_phase;
typedef int4 phase4;

typedef struct {
  reals x, y, z, w;
} Quarter;

INLINE reals load_reals(const global real* from) { return vload16(0, from); }
INLINE void store_reals(global real* to, reals values) { vstore16(values, 0, to); }
INLINE phases load_phases(const global phase* from) { return vload16(0, from); }
INLINE indices load_indices(const global int* from) { return vload16(0, from); }
INLINE indices load_entries(const global uint* from) { return as_int16(vload16(0, from)); }
INLINE coarses load_coarses(const global uint* from) { return vload16(0, from); }
INLINE floats load_floats(const global float* from) { return vload16(0, from); }
INLINE floats metres_between(coarses a, uint b) { return convert_float16(as_int16(a - b)); }
INLINE phases phases_of(reals bits) { return as_int16(bits); }
INLINE reals bits_of_phases(phases p) { return as_float16(p); }
INLINE phase4 phase4_of(real4 bits) { return as_int4(bits); }
INLINE reals to_reals(phases p) { return convert_float16(p); }
INLINE reals roots_of(reals x) { return sqrt(x); }
INLINE reals magnitudes(reals x) { return as_float16(as_int16(x) & 0x7fffffff); }
INLINE flags different(indices a, indices b) { return a != b; }
INLINE indices lanes_from(int first) {
  return first + (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
INLINE flags below(indices a, int b) { return a < b; }

// 32 yes or no for every particle, and particles that are meant.
typedef uint16 masks;
INLINE masks as_masks(int16 f) { return as_uint16(f); }
INLINE int16 as_marks(masks m) { return as_int16(m); }
INLINE void store_masks(private uint* to, masks m) { vstore16(m, 0, to); }
INLINE masks masks_of_lanes(int from, int to) {
  const int16 lanes = (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  return as_uint16((lanes >= from) & (lanes < to));
}

#if defined(__clang__) && defined(__AVX512F__)
typedef int bare_int16 __attribute__((__vector_size__(64)));
INLINE int bits_of(flags f) {
  const int16 none = 0;
  return __builtin_ia32_cmpd512_mask(__builtin_astype(f, bare_int16), __builtin_astype(none, bare_int16), 4, (ushort)-1);
}
INLINE bool any_of(flags f) { return bits_of(f) != 0; }
#else
INLINE bool any_of(flags f) {
  const int8 c = f.lo | f.hi;
  const int4 d = c.lo | c.hi;
  const int2 e = d.lo | d.hi;
  return (e.x | e.y) != 0;
}
INLINE int bits_of(flags f) {
  const int16 bits = f & (int16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
  const int8 c = bits.lo | bits.hi;
  const int4 d = c.lo | c.hi;
  const int2 e = d.lo | d.hi;
  return e.x | e.y;
}
#endif

// Two by two in place of all at once: every line is one instruction.
INLINE Quarter transposed(float16 a, float16 b, float16 c, float16 d) {
#define LOW(a, b) \
  (float16)(a.s0, b.s0, a.s1, b.s1, a.s4, b.s4, a.s5, b.s5, a.s8, b.s8, a.s9, b.s9, a.sc, b.sc, a.sd, b.sd)
#define HIGH(a, b) \
  (float16)(a.s2, b.s2, a.s3, b.s3, a.s6, b.s6, a.s7, b.s7, a.sa, b.sa, a.sb, b.sb, a.se, b.se, a.sf, b.sf)
  const float16 e = LOW(a, b), f = LOW(c, d), g = HIGH(a, b), h = HIGH(c, d);
  Quarter q;
  q.x = (float16)(e.s01, f.s01, e.s45, f.s45, e.s89, f.s89, e.scd, f.scd);
  q.y = (float16)(e.s23, f.s23, e.s67, f.s67, e.sab, f.sab, e.sef, f.sef);
  q.z = (float16)(g.s01, h.s01, g.s45, h.s45, g.s89, h.s89, g.scd, h.scd);
  q.w = (float16)(g.s23, h.s23, g.s67, h.s67, g.sab, h.sab, g.sef, h.sef);
  return q;
}

// A list says where a record is in units of eight bytes, which an address can be scaled by for nothing.
#define UNITS_A_RECORD (QUARTERS * 2)
#define RECORD_OF(k) *(const global real4*)(units + entry[k])
INLINE Quarter fetch(const global real4* records, const global uint* entry, int quarter) {
  const global ulong* units = (const global ulong*)(records + quarter);
  return transposed((float16)(RECORD_OF(0), RECORD_OF(4), RECORD_OF(8), RECORD_OF(12)),
                    (float16)(RECORD_OF(1), RECORD_OF(5), RECORD_OF(9), RECORD_OF(13)),
                    (float16)(RECORD_OF(2), RECORD_OF(6), RECORD_OF(10), RECORD_OF(14)),
                    (float16)(RECORD_OF(3), RECORD_OF(7), RECORD_OF(11), RECORD_OF(15)));
}

// Asks for the records of a slot before they are wanted, so that they come while another slot is computed.
#define ASK(k) fetch_ahead(units + entry[k])
#define ASK_FOR_ALL                                                                                                 \
  ASK(0), ASK(1), ASK(2), ASK(3), ASK(4), ASK(5), ASK(6), ASK(7), ASK(8), ASK(9), ASK(10), ASK(11), ASK(12), ASK(13), \
      ASK(14), ASK(15)
INLINE void ask_for(const global real4* records, const global uint* entry) {
  const global ulong* units = (const global ulong*)records;
  ASK_FOR_ALL;
  if (QUARTERS % 2 == 0) return;
  units += QUARTERS == 3 ? 4 : 8;  // where an odd number ends in another line of the cache, if it does
  ASK_FOR_ALL;
}

#define OWN_RECORD(k) records[(first + k) * QUARTERS + quarter]
INLINE Quarter fetch_own(const global real4* records, int first, int quarter) {
  return transposed((float16)(OWN_RECORD(0), OWN_RECORD(4), OWN_RECORD(8), OWN_RECORD(12)),
                    (float16)(OWN_RECORD(1), OWN_RECORD(5), OWN_RECORD(9), OWN_RECORD(13)),
                    (float16)(OWN_RECORD(2), OWN_RECORD(6), OWN_RECORD(10), OWN_RECORD(14)),
                    (float16)(OWN_RECORD(3), OWN_RECORD(7), OWN_RECORD(11), OWN_RECORD(15)));
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
  OWN_RECORD(8) = t.x.s89ab;
  OWN_RECORD(9) = t.y.s89ab;
  OWN_RECORD(10) = t.z.s89ab;
  OWN_RECORD(11) = t.w.s89ab;
  OWN_RECORD(12) = t.x.scdef;
  OWN_RECORD(13) = t.y.scdef;
  OWN_RECORD(14) = t.z.scdef;
  OWN_RECORD(15) = t.w.scdef;
}

// σ² − r² in double: the difference is some 1e-4 of either, and must not be rounded as they are.
INLINE reals square_gap(phases x, phases y, phases z, double4 quantum, double16 sum) {
  const double16 a = convert_double16(x) * quantum.x, b = convert_double16(y) * quantum.y,
                 c = convert_double16(z) * quantum.z;
  return convert_float16(fma(sum, sum, -fma(a, a, fma(b, b, c * c))));
}
typedef double16 lengths;
INLINE lengths length_in(phases p, double unit) { return convert_double16(p) * unit; }
INLINE reals rounded(lengths l) { return convert_float16(l); }
INLINE lengths exact_phases(phases p) { return convert_double16(as_uint16(p)); }
INLINE lengths exact_indices(indices i) { return convert_double16(i); }
INLINE lengths cells_entered(phases now, phases then) {
  const phases moved = now - then;
  const phases next = (moved >= 0) & (as_uint16(now) < as_uint16(then));
  const phases last = (moved < 0) & (as_uint16(now) > as_uint16(then));
  return convert_double16(last - next);  // yes is −1
}

// Where the numbers of the k-th kind that a particle keeps to itself lie: what is left of its position below a
// unit, and what rounding left out of its velocity.
#define KEPT 6

INLINE phases displaced(phases p, global real* part, reals move) {
  const int16 leap = convert_int16(move);
  const reals left = load_reals(part) + (move - convert_float16(leap));
  const int16 more = convert_int16(left);
  store_reals(part, left - convert_float16(more));
  return p + leap + more;
}

// To within a unit, for those that only look.
INLINE phases displaced_roughly(phases p, reals move) { return p + convert_int16(move); }

// Kicks a velocity along an axis and moves with it, losing nothing: docs/precision.md.
INLINE phases kick_and_move(phases p, reals* velocity, global real* part, global real* rest, reals change, real drift,
                            flags moves) {
  const reals left_out = load_reals(rest);
  const reals y = change + left_out, sum = *velocity + y, seen = sum - *velocity;
  store_reals(rest, moves ? (*velocity - (sum - seen)) + (y - seen) : left_out);
  *velocity = moves ? sum : *velocity;
  return displaced(p, part, moves ? sum * drift : 0);
}

INLINE flags flags_of(long16 f) { return convert_int16(f); }

typedef long16 wholes;
INLINE wholes to_wholes(reals x) { return convert_long16(x); }
INLINE reals from_wholes(wholes w) { return convert_float16(w); }
