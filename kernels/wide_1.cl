// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// One particle a work-item, for devices whose work-items are lanes themselves: what dense_*.cl does with many at
// once, it does here with scalars. A group is as many as go in step on such a device, so that a slot's row of
// entries, or of springs, is read in one piece.
#define LANES 1
#define GROUP 32
#define KNOWN constant
typedef real reals;
typedef bare_phase phases;  // differences wrap, which those of signed scalars need not
typedef int flags;
typedef int indices;

typedef struct {
  reals x, y, z, w;
} Quarter;

INLINE reals load_reals(const global real* from) { return *from; }
INLINE void store_reals(global real* to, reals values) { *to = values; }
INLINE phases load_phases(const global phase* from) { return (phases)*from; }
INLINE indices load_indices(const global int* from) { return *from; }
INLINE indices load_entries(const global uint* from) { return (int)*from; }
INLINE reals to_reals(phases p) { return (real)(phase)p; }
INLINE reals roots_of(reals x) { return sqrt(x); }
INLINE reals magnitudes(reals x) { return fabs(x); }
INLINE flags different(indices a, indices b) { return a != b; }
INLINE indices lanes_from(int first) { return first; }
INLINE flags below(indices a, int b) { return a < b; }
INLINE bool any_of(flags f) { return f != 0; }
INLINE int bits_of(flags f) { return f & 1; }
INLINE flags flags_of(int f) { return f; }

INLINE Quarter quarter_of(real4 v) {
  const Quarter q = {v.x, v.y, v.z, v.w};
  return q;
}

// A list says where a record is in units of eight bytes: kernels/wide_single_16.cl.
#define UNITS_A_RECORD (QUARTERS * (int)(sizeof(real4) / 8))
INLINE Quarter fetch(const global real4* records, const global uint* entry, int quarter) {
  return quarter_of(*(const global real4*)((const global ulong*)(records + quarter) + *entry));
}
INLINE void ask_for(const global real4* records, const global uint* entry) {}  // such a device has others to run meanwhile
INLINE Quarter fetch_own(const global real4* records, int first, int quarter) {
  return quarter_of(records[first * QUARTERS + quarter]);
}
INLINE void store_own(global real4* records, int first, int quarter, Quarter q) {
  records[first * QUARTERS + quarter] = (real4)(q.x, q.y, q.z, q.w);
}

typedef double lengths;
INLINE lengths length_in(phases p, double unit) { return (double)(phase)p * unit; }
INLINE reals rounded(lengths l) { return (real)l; }
INLINE lengths exact_phases(phases p) { return (double)p; }
INLINE lengths exact_indices(indices i) { return (double)i; }
INLINE lengths cells_entered(phases now, phases then) {
  if ((phase)(now - then) >= 0) return now < then ? 1.0 : 0.0;
  return now > then ? -1.0 : 0.0;
}

// σ² − r² in double, as wide_single_16.cl and wide_double_8.cl have it.
INLINE reals square_gap(phases x, phases y, phases z, double4 quantum, double sum) {
  const double a = (double)(phase)x * quantum.x, b = (double)(phase)y * quantum.y, c = (double)(phase)z * quantum.z;
  return (real)fma(sum, sum, -fma(a, a, fma(b, b, c * c)));
}

typedef long wholes;
INLINE wholes to_wholes(reals x) { return (long)x; }
INLINE reals from_wholes(wholes w) { return (real)w; }
