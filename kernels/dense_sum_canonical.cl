// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Sums that no order can change: whole multiples of a unit so small that rounding to it does not matter. The host
// chooses it so that no sum of a particle can overflow. Where the device's reals are finer than that, what is left
// is summed as well, in units that are FINER.
typedef struct {
  wholes coarse;
#ifdef FINER
  wholes fine;
#endif
} Whole;

typedef struct {
  Whole x, y, z;
} Sum;

INLINE Sum no_sum() {
  const Sum none = {{0}, {0}, {0}};
  return none;
}

INLINE void add_to(Whole* sum, reals units) {
  const wholes coarse = to_wholes(units);
  sum->coarse += coarse;
#ifdef FINER
  sum->fine += to_wholes((units - from_wholes(coarse)) * FINER);
#endif
}

INLINE reals reals_of(Whole sum) {
#ifdef FINER
  return from_wholes(sum.coarse) + from_wholes(sum.fine) * (1 / FINER);
#else
  return from_wholes(sum.coarse);
#endif
}

INLINE void add(Sum* sum, Vectors v, real unit) {
  add_to(&sum->x, v.x * (1 / unit));
  add_to(&sum->y, v.y * (1 / unit));
  add_to(&sum->z, v.z * (1 / unit));
}
INLINE Vectors total_of(Sum sum, real unit) {
  return vectors(reals_of(sum.x) * unit, reals_of(sum.y) * unit, reals_of(sum.z) * unit);
}
