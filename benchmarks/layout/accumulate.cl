// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Forces of pairs on both of their bodies: added by compare-and-swap, or written down and gathered.
void add_atomically(volatile __global float* sum, float value) {
  volatile __global uint* bits = (volatile __global uint*)sum;
  uint before = *bits, expected;
  do {
    expected = before;
    before = atomic_cmpxchg(bits, expected, as_uint(as_float(expected) + value));
  } while (before != expected);
}

float4 pair_force(float4 one, float4 two) {
  const float4 apart = two - one;
  return apart * fmax(1.0f - dot(apart, apart), 0.0f);
}

__kernel void compare_and_swap(__global const float4* position, __global const int2* pairs, int count,
                               __global float* forces) {
  const int k = get_global_id(0);
  if (k >= count) return;
  const int2 pair = pairs[k];
  const float4 force = pair_force(position[pair.x], position[pair.y]);
  add_atomically(forces + 4 * pair.x, force.x);
  add_atomically(forces + 4 * pair.x + 1, force.y);
  add_atomically(forces + 4 * pair.x + 2, force.z);
  add_atomically(forces + 4 * pair.y, -force.x);
  add_atomically(forces + 4 * pair.y + 1, -force.y);
  add_atomically(forces + 4 * pair.y + 2, -force.z);
}

__kernel void write_down(__global const float4* position, __global const int2* pairs, int count,
                         __global float4* slots) {
  const int k = get_global_id(0);
  if (k < count) slots[k] = pair_force(position[pairs[k].x], position[pairs[k].y]);
}

/// `entries`: slot of each pair of a particle, negative (−1 − slot) where it is the pair's second.
__kernel void gather(__global const float4* slots, __global const int* starts, __global const int* entries,
                     __global float4* forces) {
  const size_t i = get_global_id(0);
  float4 force = (float4)(0.0f);
  for (int k = starts[i]; k < starts[i + 1]; ++k) {
    const int entry = entries[k];
    force += entry >= 0 ? slots[entry] : -slots[-1 - entry];
  }
  forces[i] = force;
}
