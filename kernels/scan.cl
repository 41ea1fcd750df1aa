// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Exclusive scan of integers, reduce-then-scan: blocks are summed, the sums scanned (by the same two kernels, as
// often as it takes), then every block scanned from its offset. No group ever waits for another.
#define SCAN_ITEMS 8

INLINE int items_sum(const global int* values, int from, int count) {
  int sum = 0;
  for (int k = from; k < from + SCAN_ITEMS; ++k) sum += k < count ? values[k] : 0;
  return sum;
}

kernel void scan_reduce(const global int* values, global int* block_sums, local int* partial, const int count) {
  const int item = get_local_id(0);
  partial[item] = items_sum(values, get_global_id(0) * SCAN_ITEMS, count);
  for (int stride = get_local_size(0) / 2; stride > 0; stride /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < stride) partial[item] += partial[item + stride];
  }
  if (item == 0) block_sums[get_group_id(0)] = partial[0];
}

kernel void scan_blocks(const global int* values, const global int* block_starts, global int* starts,
                        local int* partial, const int count) {
  const int item = get_local_id(0), from = get_global_id(0) * SCAN_ITEMS;
  const int own = items_sum(values, from, count);
  partial[item] = own;
  barrier(CLK_LOCAL_MEM_FENCE);
  for (int stride = 1; stride < (int)get_local_size(0); stride *= 2) {
    const int before = item >= stride ? partial[item - stride] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    partial[item] += before;
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  int start = block_starts[get_group_id(0)] + partial[item] - own;
  for (int k = from; k < from + SCAN_ITEMS && k < count; ++k) {
    starts[k] = start;
    start += values[k];
  }
}
