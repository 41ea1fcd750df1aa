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
  const Vec3 from_centre = box.nearest_image(position - box.inside(centre));
  const Vec3 away = from_centre - from_centre.cwiseMax(-half).cwiseMin(half);
  const double distance = away.norm();
  return {away / distance, distance};
}

/// From a wall's reference point to a point of its surface next to a body.
template <class Shape>
Vec3 arm_to(const Shape& shape, const Vec3& on_surface, const PeriodicBox&) {
  return on_surface - shape.point;
}

/// Of the image that the body touches, wherever motion has taken the wall.
inline Vec3 arm_to(const Rectangle& rectangle, const Vec3& on_surface, const PeriodicBox& box) {
  const Vec3 centre = 0.5 * (rectangle.lower + rectangle.upper);
  return box.nearest_image(on_surface - box.inside(centre)) + (centre - rectangle.lower);
}

/// Undefined normal on the axis itself, which is far beyond any overlap limit of a cylinder that holds its
/// particles.
inline Nearest nearest(const Cylinder& cylinder, const Vec3& position, const PeriodicBox&) {
  const Vec3 from_point = position - cylinder.point;
  const Vec3 outward = from_point - from_point.dot(cylinder.axis) * cylinder.axis;
  const double from_axis = outward.norm();
  const double side = cylinder.side == Cylinder::Side::inside ? -1.0 : 1.0;
  return {outward * (side / from_axis), side * (from_axis - cylinder.radius)};
}

}  // namespace grainproof::reference
