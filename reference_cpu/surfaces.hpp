// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/walls.hpp"
#include "reference_cpu/periodic_box.hpp"

/// Where a wall is nearest to a point: face, edge or corner alike.
namespace grainproof::reference {

struct Nearest {
  Vec3 normal;      ///< from the wall to the point
  double distance;  ///< negative inside the solid of a plane
};

inline Nearest nearest(const Plane& plane, const Vec3& position, const PeriodicBox&) {
  return {plane.normal, (position - plane.point).dot(plane.normal)};
}

/// Undefined normal on the rectangle itself, which is far beyond any overlap limit.
inline Nearest nearest(const Rectangle& rectangle, const Vec3& position, const PeriodicBox& box) {
  const Vec3 centre = 0.5 * (rectangle.lower + rectangle.upper);
  const Vec3 half = 0.5 * (rectangle.upper - rectangle.lower);
  const Vec3 from_centre = box.nearest_image(position - centre);
  const Vec3 away = from_centre - from_centre.cwiseMax(-half).cwiseMin(half);
  const double distance = away.norm();
  return {away / distance, distance};
}

}  // namespace grainproof::reference
