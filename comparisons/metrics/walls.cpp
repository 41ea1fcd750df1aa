// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/walls.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/laws.hpp"

namespace grainproof {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// How far the wall is from where it is drawn.
Vec3 shift(const WallMotion& motion, double time) {
  return std::visit(Overloaded{[](const Still&) -> Vec3 { return Vec3::Zero(); },
                               [&](const Translating& moves) -> Vec3 { return time * moves.velocity; },
                               [](const Rotating&) -> Vec3 { return Vec3::Zero(); },
                               [&](const Vibrating& moves) -> Vec3 {
                                 const double angle = 2.0 * std::numbers::pi * moves.frequency * time;
                                 return (std::sin(angle + moves.phase) - std::sin(moves.phase)) *
                                        moves.amplitude;
                               }},
                    motion);
}

/// Of the surface's point `at`, with the shift taken off; `axis` is what the wall turns about.
Vec3 velocity(const WallMotion& motion, double time, const Vec3& axis, const Vec3& arm) {
  return std::visit(Overloaded{[](const Still&) -> Vec3 { return Vec3::Zero(); },
                               [](const Translating& moves) -> Vec3 { return moves.velocity; },
                               [&](const Rotating& turns) -> Vec3 { return turns.rate * axis.cross(arm); },
                               [&](const Vibrating& moves) -> Vec3 {
                                 const double rate = 2.0 * std::numbers::pi * moves.frequency;
                                 return rate * std::cos(rate * time + moves.phase) * moves.amplitude;
                               }},
                    motion);
}

Vec3 from_axis(const Cylinder& cylinder, const Vec3& x) {
  const Vec3 apart = x - cylinder.point;
  return apart - apart.dot(cylinder.axis) * cylinder.axis;
}

double inward(const Cylinder& cylinder) {
  return cylinder.side == Cylinder::Side::inside ? -1.0 : 1.0;
}

Facing facing(const Plane& plane, const WallMotion& motion, const Vec3& x, double time) {
  const double distance = (x - plane.point).dot(plane.normal);
  const Vec3 foot = x - distance * plane.normal;
  return {distance, plane.normal, velocity(motion, time, plane.normal, foot - plane.point)};
}

Facing facing(const Cylinder& cylinder, const WallMotion& motion, const Vec3& x, double time) {
  const Vec3 apart = from_axis(cylinder, x);
  const Vec3 outward = apart.normalized();
  const double side = inward(cylinder);
  return {side * (apart.norm() - cylinder.radius), side * outward,
          velocity(motion, time, cylinder.axis, cylinder.radius * outward)};
}

Facing facing(const Rectangle& rectangle, const WallMotion& motion, const Vec3& x, double time) {
  const Vec3 apart = x - x.cwiseMax(rectangle.lower).cwiseMin(rectangle.upper);
  return {apart.norm(), apart.normalized(), velocity(motion, time, Vec3::Zero(), Vec3::Zero())};
}

/// |p + w t| = reach, from inside where `side` is negative.
double radial_time(const Vec3& p, const Vec3& w, double reach, double side) {
  const double speed = w.squaredNorm();
  const double along = p.dot(w);
  const double discriminant = along * along - speed * (p.squaredNorm() - reach * reach);
  if (speed == 0.0 || discriminant < 0.0 || (side > 0.0 && along >= 0.0)) return never;
  return (-along - side * std::sqrt(discriminant)) / speed;
}

}  // namespace

Facing facing(const Wall& wall, const Vec3& x, double time) {
  const Vec3 drawn = x - shift(wall.motion, time);
  return std::visit([&](const auto& shape) { return facing(shape, wall.motion, drawn, time); }, wall.shape);
}

double time_to_reach(const Wall& wall, const Vec3& x, double time, const Vec3& velocity, double reach) {
  if (const auto* cylinder = std::get_if<Cylinder>(&wall.shape)) {
    const Vec3 across = velocity - velocity.dot(cylinder->axis) * cylinder->axis;
    const double side = inward(*cylinder);
    return radial_time(from_axis(*cylinder, x - shift(wall.motion, time)), across,
                       cylinder->radius + side * reach, side);
  }
  const Facing seen = facing(wall, x, time);
  const double approach = -velocity.dot(seen.normal);
  return approach > 0.0 ? (seen.distance - reach) / approach : never;
}

}  // namespace grainproof
