// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "model/scene.hpp"
#include "opencl/near_walls.hpp"
#include "opencl/precision.hpp"

namespace grainproof::opencl {

using Bytes = std::vector<std::byte>;

/// Turns what a device holds back into numbers; positions exactly, in double.
class Decoder {
 public:
  virtual ~Decoder() = default;
  virtual Vec3 position(std::span<const std::byte> positions, std::size_t i) const = 0;
  virtual Vec3 vector(std::span<const std::byte> vectors, std::size_t i) const = 0;
  /// A quaternion, whose scalar part is held last.
  virtual Quaternion quaternion(std::span<const std::byte> vectors, std::size_t i) const = 0;
  /// Writes a vector and a fourth number, rounded to the precision.
  virtual void put(std::span<std::byte> vectors, std::size_t i, const Vec3& vector, double fourth) const = 0;
  virtual double fourth(std::span<const std::byte> vectors, std::size_t i) const = 0;
  virtual std::size_t position_bytes() const = 0;
  virtual std::size_t vector_bytes() const = 0;
  virtual std::size_t reach_bytes() const = 0;
  virtual std::size_t tally_bytes() const = 0;
  virtual std::size_t ledger_bytes() const = 0;
  virtual std::size_t wall_tally_bytes() const = 0;
  virtual std::size_t wall_sums_bytes() const = 0;
};

std::unique_ptr<Decoder> make_decoder(Precision precision, const Domain& domain);

/// Sizes of a grid of zones and how far a list looks.
struct ZoneGrid {
  std::array<int, 3> zones{1, 1, 1};
  double skin = 0.0;  ///< m
  int total() const { return zones[0] * zones[1] * zones[2]; }
};

/// Zones at least cut-off + skin wide, not many more than particles.
ZoneGrid choose_zones(const Scene& scene, double skin);

/// A scene as a device takes it, one member a buffer, particles padded to a multiple of the work-group.
struct SceneImage {
  Bytes box, constants, laws, planes, rectangles, cylinders;
  Bytes materials, reaches, drag_rates;
  Bytes positions, velocities;
  Bytes spins;     ///< one entry without rotation
  Bytes as_drawn;  ///< the orientation that every particle starts with
  NearWalls near;
  std::size_t particles = 0;
  std::size_t padded = 0;
};

SceneImage make_image(const Scene& scene, Precision precision, const ZoneGrid& grid, std::size_t work_group);

/// Gravity at steps first … last, for fields that change with time: one vector of the precision a step.
Bytes gravity_table(const Gravity& gravity, double step, std::int64_t first, std::int64_t last,
                    Precision precision);

/// Sizes of the types that kernels share with the host, in the order of kernels/sizes.cl.
std::array<int, 13> shared_sizes(Precision precision);

}  // namespace grainproof::opencl
