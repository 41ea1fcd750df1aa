// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "opencl/limits.hpp"
#include "opencl/near_walls.hpp"
#include "opencl/wall_image.hpp"

namespace grainproof::opencl {
namespace {

bool any_periodic(const Domain& domain) {
  return domain.periodic(0) || domain.periodic(1) || domain.periodic(2);
}

bool parallel_to_periods(const Cylinder& cylinder, const Domain& domain) {
  for (int axis = 0; axis < 3; ++axis)
    if (domain.periodic(axis) && cylinder.axis.cwiseAbs() != Vec3::Unit(axis)) return false;
  return true;
}

Support can_turn(const Wall& wall, const Domain& domain) {
  if (!std::holds_alternative<Rotating>(wall.motion)) return {};
  if (std::holds_alternative<Rectangle>(wall.shape))
    return Support::no("the wall " + wall.name + " cannot rotate: a rectangle has no turn within itself");
  if (std::holds_alternative<Plane>(wall.shape) && any_periodic(domain))
    return Support::no("the wall " + wall.name + " cannot rotate: a turning plane has no period");
  return {};
}

/// Single precision measures a cylinder by the domain: its axis and its surface must be nearby.
Support near_enough(const Cylinder& cylinder, const Wall& wall, const Scene& scene, double reach) {
  const double longest = scene.domain.extent().maxCoeff();
  const Vec3 middle = (scene.domain.lower + scene.domain.upper) / 2;
  const Vec3 aside = cylinder.point - middle - (cylinder.point - middle).dot(cylinder.axis) * cylinder.axis;
  if (aside.norm() + farthest_shift(wall.motion, scene.run.end) > 1.25 * longest ||
      cylinder.radius + reach > 1.9 * longest)
    return Support::no("the cylinder " + wall.name +
                       " reaches farther than the domain, by which single precision measures positions");
  return {};
}

}  // namespace

Support wall_within_limits(const Wall& wall, const Scene& scene, Precision precision) {
  if (const Support turns = can_turn(wall, scene.domain); !turns) return turns;
  const auto* cylinder = std::get_if<Cylinder>(&wall.shape);
  if (cylinder == nullptr) return {};
  const double reach = largest_reach(scene);
  if (cylinder->side == Cylinder::Side::inside && cylinder->radius <= reach)
    return Support::no("the largest particle does not fit into the cylinder " + wall.name);
  if (!parallel_to_periods(*cylinder, scene.domain))
    return Support::no("the axis of the cylinder " + wall.name + " does not lie along every periodic axis");
  if (precision == Precision::single_precision) return near_enough(*cylinder, wall, scene, reach);
  return {};
}

}  // namespace grainproof::opencl
