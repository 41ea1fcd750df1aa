// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/near_walls.hpp"

#include <algorithm>

namespace grainproof::opencl {
namespace {

/// Where a plane comes nearest to the corner of the domain that lies deepest on its side.
bool can_touch(const Plane& plane, const Domain& domain, double reach) {
  Vec3 deepest;
  for (int axis = 0; axis < 3; ++axis)
    deepest[axis] = plane.normal[axis] > 0.0 ? domain.lower[axis] : domain.upper[axis];
  return (deepest - plane.point).dot(plane.normal) < reach;
}

bool can_touch(const Rectangle& rectangle, const Domain& domain, double reach) {
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.periodic(axis)) continue;
    if (rectangle.lower[axis] > domain.upper[axis] + reach) return false;
    if (rectangle.upper[axis] < domain.lower[axis] - reach) return false;
  }
  return true;
}

/// Edges beyond every particle's reach come nearer; no closest point to a centre in the domain changes.
Rectangle clipped(const Rectangle& rectangle, const Domain& domain, double reach) {
  const Vec3 margin = Vec3::Constant(reach);
  const Vec3 lowest = domain.lower - margin, highest = domain.upper + margin;
  return {rectangle.lower.cwiseMax(lowest).cwiseMin(highest),
          rectangle.upper.cwiseMin(highest).cwiseMax(lowest)};
}

}  // namespace

double largest_reach(const Scene& scene) {
  double reach = 0.0;
  for (const Particle& p : scene.particles) reach = std::max({reach, p.diameter / 2, p.effect_diameter / 2});
  return reach;
}

NearWalls near_walls(const Scene& scene) {
  const double reach = largest_reach(scene);
  NearWalls near;
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    const Wall& wall = scene.walls[i];
    const auto index = static_cast<std::int32_t>(i);
    if (const auto* plane = std::get_if<Plane>(&wall.shape)) {
      if (can_touch(*plane, scene.domain, reach)) near.planes.push_back({*plane, wall.material, index});
    } else if (const auto* rectangle = std::get_if<Rectangle>(&wall.shape)) {
      if (can_touch(*rectangle, scene.domain, reach))
        near.rectangles.push_back({clipped(*rectangle, scene.domain, reach), wall.material, index});
    }
  }
  return near;
}

}  // namespace grainproof::opencl
