// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Sums in the order in which partners stand in the list.
typedef Vectors Sum;

INLINE Sum no_sum() { return vectors(0, 0, 0); }
INLINE void add(Sum* sum, Vectors v, real unit) { *sum = plus_scaled(*sum, v, (reals)(1)); }
INLINE Vectors total_of(Sum sum, real unit) { return sum; }
