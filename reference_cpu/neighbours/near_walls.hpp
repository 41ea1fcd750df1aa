// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "model/walls.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/periodic_box.hpp"

namespace grainproof::reference {

/// For each wall the moving particles that could touch it before they have moved half the skin.
class NearWalls {
 public:
  explicit NearWalls(std::span<const Wall> walls) : walls_(walls), near_(walls.size()) {}

  void list(const Bodies& bodies, const PeriodicBox& box, double skin);

  /// Indices of particles, rising.
  std::span<const std::int32_t> near(std::size_t wall) const { return near_[wall]; }

 private:
  std::span<const Wall> walls_;
  std::vector<std::vector<std::int32_t>> near_;
};

}  // namespace grainproof::reference
