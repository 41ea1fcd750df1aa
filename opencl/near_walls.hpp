// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::opencl {

template <class Shape>
struct NearWall {
  Shape shape;
  std::int32_t material;
  std::int32_t index;  ///< among Scene::walls
  WallMotion motion;
  Vec3 reference;    ///< at the start, m; model/walls.hpp
  std::int32_t row;  ///< among the walls whose place changes; −1 for others
};

/// The walls that a particle inside the domain can touch, in the order in which kernels meet them; rectangles
/// that stay where they are without what lies far outside.
struct NearWalls {
  std::vector<NearWall<Plane>> planes;
  std::vector<NearWall<Rectangle>> rectangles;
  std::vector<NearWall<Cylinder>> cylinders;

  std::size_t count() const { return planes.size() + rectangles.size() + cylinders.size(); }
  /// Calls `act` with every wall.
  template <class Act>
  void each(const Act& act) const {
    for (const auto& wall : planes) act(wall);
    for (const auto& wall : rectangles) act(wall);
    for (const auto& wall : cylinders) act(wall);
  }
  /// Number of walls whose place changes.
  std::size_t moving() const;
  /// Whether any surface moves, be it along itself.
  bool any_moves() const;
};

/// Whether the place of a wall changes, and not only its surface along itself.
bool changes_place(const WallMotion& motion);

NearWalls near_walls(const Scene& scene);

/// Without what is out of every particle's reach, and around the domain's own image along periodic axes; no
/// closest point to a centre in the domain changes.
Rectangle within_reach(const Rectangle& rectangle, const Domain& domain, double reach);

/// Half the largest effect diameter, m.
double largest_reach(const Scene& scene);

}  // namespace grainproof::opencl
