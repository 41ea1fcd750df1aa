// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <vector>

#include "opencl/cl.hpp"

namespace grainproof::bench {

/// The bed as the layout kernels take it: lengths in diameters, as many particles as fill their work-groups.
struct LayoutData {
  std::vector<cl_float4> positions;  ///< sorted along zones
  std::vector<cl_int2> pairs;        ///< each close pair once
  std::vector<cl_int> starts;        ///< of each particle's partners, and their end
  std::vector<cl_int> partners;
  std::vector<cl_int> entries;  ///< slot of a pair; −1 − slot where the particle is its second
};

LayoutData layout_data(std::int64_t particles, const std::filesystem::path& cache);

struct ZonedData {
  std::vector<cl_float4> positions;
  std::vector<cl_int> zone_starts;
  cl_int4 zones;
  cl_float4 inverse_width;
  cl_int around;  ///< zones to look at on every side
  cl_float reach2;
};

/// With zones `share` of the reach wide.
ZonedData sort_by_zones(const LayoutData& data, double share);

}  // namespace grainproof::bench
