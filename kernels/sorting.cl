// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Insertion sort of a few integers, mostly in order already.
INLINE void sort_few(global int* values, int count) {
  for (int k = 1; k < count; ++k) {
    const int value = values[k];
    int hole = k;
    for (; hole > 0 && values[hole - 1] > value; --hole) values[hole] = values[hole - 1];
    values[hole] = value;
  }
}
