// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "model/sections.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/periodic_box.hpp"
#include "reference_cpu/walls.hpp"

namespace grainproof::reference {

/// For each wall the moving particles that could touch it before they and it have each moved half the skin.
class NearWalls {
 public:
  explicit NearWalls(std::size_t walls) : near_(walls) {}

  void list(const Walls& walls, const Bodies& bodies, const PeriodicBox& box, double skin);

  /// Whether a wall has moved so far since the list was made.
  bool outdated(const Walls& walls, double skin) const;

  /// Indices of particles, rising.
  std::span<const std::int32_t> near(std::size_t wall) const { return near_[wall]; }

  void pack_into(Sections& own) const;
  void unpack_from(const Sections& own);

 private:
  std::vector<std::vector<std::int32_t>> near_;
  std::vector<Vec3> reference_when_made_;
};

}  // namespace grainproof::reference
