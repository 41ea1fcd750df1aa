// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Sums that no order can change: whole multiples of a unit so small that rounding to it does not matter. The host
// chooses it so that no sum of a particle can overflow.
typedef struct {
  wholes x, y, z;
} Sum;

INLINE Sum no_sum() {
  const Sum none = {0, 0, 0};
  return none;
}
INLINE void add(Sum* sum, Vectors v, real unit) {
  sum->x += to_wholes(v.x * (1 / unit));
  sum->y += to_wholes(v.y * (1 / unit));
  sum->z += to_wholes(v.z * (1 / unit));
}
INLINE Vectors total_of(Sum sum, real unit) {
  return vectors(from_wholes(sum.x) * unit, from_wholes(sum.y) * unit, from_wholes(sum.z) * unit);
}
