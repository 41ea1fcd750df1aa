// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/peers/walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace grainproof::peers {
namespace {

bool spans_domain(const Rectangle& rectangle, int across, const Domain& domain) {
  for (int axis = 0; axis < 3; ++axis)
    if (axis != across &&
        (rectangle.lower[axis] > domain.lower[axis] || rectangle.upper[axis] < domain.upper[axis]))
      return false;
  return true;
}

bool is_behind(const Wall& wall, const Vec3& x) {
  if (const auto* plane = std::get_if<Plane>(&wall.shape)) return (x - plane->point).dot(plane->normal) < 0.0;
  const auto* round = std::get_if<Cylinder>(&wall.shape);
  if (!round) return false;
  const double from_axis = (x - round->point).cross(round->axis).norm();
  return (from_axis > round->radius) == (round->side == Cylinder::Side::inside);
}

}  // namespace

std::optional<AxisPlane> axis_plane(const Wall& wall, const Domain& domain) {
  int axis = 0;
  if (const auto* plane = std::get_if<Plane>(&wall.shape)) {
    if (plane->normal.cwiseAbs().maxCoeff(&axis) != 1.0) return std::nullopt;
    return AxisPlane{axis, plane->point[axis]};
  }
  const auto* rectangle = std::get_if<Rectangle>(&wall.shape);
  if (!rectangle) return std::nullopt;
  (rectangle->upper - rectangle->lower).minCoeff(&axis);
  if (!spans_domain(*rectangle, axis, domain)) return std::nullopt;
  return AxisPlane{axis, rectangle->lower[axis]};
}

std::optional<AxisSpeed> axis_speed(const Vec3& velocity) {
  int axis = 0;
  const double speed = velocity.cwiseAbs().maxCoeff(&axis);
  if (speed == 0.0 || speed != velocity.norm()) return std::nullopt;
  return AxisSpeed{axis, velocity[axis]};
}

std::optional<int> lengthwise(const Cylinder& cylinder) {
  int axis = 0;
  if (cylinder.axis.cwiseAbs().maxCoeff(&axis) != 1.0) return std::nullopt;
  return axis;
}

Support open_side_support(const Scene& scene, const Wall& wall, const std::string& program) {
  const bool behind = std::any_of(scene.particles.begin(), scene.particles.end(),
                                  [&](const Particle& body) { return is_behind(wall, body.position); });
  return behind
             ? Support::no("a particle starts behind a wall, which " + program + " has solid from both sides")
             : Support{};
}

}  // namespace grainproof::peers
