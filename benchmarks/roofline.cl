// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What the device can do at best: copying memory, and multiplying and adding in registers.
__kernel void copy(__global const float16* from, __global float16* to) {
  const size_t i = get_global_id(0);
  to[i] = from[i];
}

// Ten chains, so that none waits for another; the sum is stored so that nothing is left out.
#define CHAINS(STEP) STEP(0) STEP(1) STEP(2) STEP(3) STEP(4) STEP(5) STEP(6) STEP(7) STEP(8) STEP(9)
#define DECLARE(n) float16 x##n = (float16)(start + n);
#define ADVANCE(n) x##n = fma(x##n, factor, addend);
#define ADD(n) sum += x##n;

__kernel void multiply_add(__global float16* out, float start, int rounds) {
  const float16 factor = (float16)(0.9999f), addend = (float16)(1e-4f);
  CHAINS(DECLARE)
  for (int n = 0; n < rounds; ++n) {
    CHAINS(ADVANCE)
  }
  float16 sum = (float16)(0.0f);
  CHAINS(ADD)
  out[get_global_id(0)] = sum;
}
