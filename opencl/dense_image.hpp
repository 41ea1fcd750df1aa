// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "model/scene.hpp"
#include "opencl/dense_options.hpp"
#include "opencl/layout.hpp"
#include "opencl/scene_image.hpp"

namespace grainproof::opencl {

/// The host's twins of the types in kernels/dense_box.cl.
template <class P>
struct DenseBox {
  cl_double4 quantum, lower, cell, domain_lower, domain_upper, coarse, alike;
  typename P::Real4 metre, drift, gravity, time, limits, body, body_units;
  cl_float4 coarse_metre, near;
  cl_int4 cells, zones, counts, periodic;
};

struct DensePlane {
  cl_double4 normal;
  cl_int4 wall;
};

/// Cells in which phases are counted, and zones of which lists are made. Axes that are not periodic extend
/// beyond the domain by more than any pair's reach, so that nothing meets across their ends.
struct DenseGrid {
  DenseGrid(const Scene& scene, double list_skin);

  int zones() const { return zone_counts[0] * zone_counts[1] * zone_counts[2]; }

  Vec3 lower, extent, cell;
  std::array<int, 3> cells{}, zone_counts{};
  std::array<bool, 3> periodic{};
  double skin, largest_radius;
};

/// A scene as the dense path takes it, one member a buffer, particles in the order of the scene.
struct DenseImage {
  Bytes box, planes, laws, records, kept, built_at, cells;
  std::size_t particles = 0;
  std::size_t padded = 0;  ///< to whole work-groups of whole groups
};

DenseImage make_dense_image(const Scene& scene, const DenseOptions& options, const DenseGrid& grid,
                            std::size_t granularity);

/// Its box alone, for another grid.
Bytes make_dense_box(const Scene& scene, const DenseOptions& options, const DenseGrid& grid);

/// One particle as the device has it.
struct DenseBody {
  Vec3 position, velocity, spin;
};

/// What was read back of all particles, in the device's order.
struct DenseRecords {
  Bytes records, kept, built_at, cells;
  std::vector<cl_int> ids;
};

/// Body at place `i` of the device's order.
DenseBody decoded(const DenseRecords& read, std::size_t i, const DenseOptions& options,
                  const DenseGrid& grid);

}  // namespace grainproof::opencl
