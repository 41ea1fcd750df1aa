// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Partners within reach, by zones that are a share of the reach wide. Particles are sorted by zone.
__kernel void count_partners(__global const float4* position, __global const int* zone_starts,
                             __global int* counts, int4 zones, float4 inverse_width, int around, float reach2) {
  const int i = get_global_id(0);
  const float4 here = position[i];
  const int4 zone = convert_int4(here * inverse_width);
  const int4 low = max(zone - around, (int4)(0)), high = min(zone + around, zones - 1);
  int found = 0;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y) {
      // zones along x lie one after the other, so a row of them is one stretch of particles
      const int row = (z * zones.y + y) * zones.x;
      for (int k = zone_starts[row + low.x]; k < zone_starts[row + high.x + 1]; ++k) {
        const float4 apart = position[k] - here;
        found += dot(apart, apart) < reach2;
      }
    }
  counts[i] = found - 1;
}
