// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Exclusive sums of N numbers: by one work-item, or by blocks that are reduced, scanned and filled in.
__kernel void serial_scan(__global const int* values, __global int* starts, int count) {
  int sum = 0;
  for (int i = 0; i < count; ++i) {
    starts[i] = sum;
    sum += values[i];
  }
}

__kernel void reduce_blocks(__global const int* values, __global int* sums, int block) {
  const int b = get_global_id(0);
  int sum = 0;
  for (int i = b * block; i < (b + 1) * block; ++i) sum += values[i];
  sums[b] = sum;
}

__kernel void fill_blocks(__global const int* values, __global const int* block_starts, __global int* starts,
                          int block) {
  const int b = get_global_id(0);
  int sum = block_starts[b];
  for (int i = b * block; i < (b + 1) * block; ++i) {
    starts[i] = sum;
    sum += values[i];
  }
}
