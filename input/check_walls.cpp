// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "input/set_up.hpp"
#include "input/text.hpp"

namespace grainproof::input {
namespace {

double largest_radius(const Scene& scene, bool moving_only) {
  double largest = 0.0;
  for (const Particle& particle : scene.particles)
    if (!(moving_only && particle.fixed)) largest = std::max(largest, 0.5 * particle.diameter);
  return largest;
}

/// Round-off of an axis given as a sum of squares.
constexpr double along_axis = 1e-12;

/// How far a wall reaches along one axis.
struct Reach {
  bool endless = false;  ///< the same all along the axis
  bool beyond = false;   ///< to infinity without being the same
  double low = 0.0;
  double high = 0.0;
};

Reach reach_of(const Plane&, int) {
  return {.endless = true};  // planes across a period are refused where they stand
}

/// Particles inside stay between the surfaces; outside, their own width counts as well.
Reach reach_of(const Cylinder& cylinder, int axis, double radius) {
  const double along = std::abs(cylinder.axis[axis]);
  if (along > 1.0 - along_axis) return {.endless = true};
  if (along > along_axis) return {.beyond = true};
  const double wide = cylinder.radius + (cylinder.side == Cylinder::Side::outside ? radius : 0.0);
  return {.low = cylinder.point[axis] - wide, .high = cylinder.point[axis] + wide};
}

Reach reach_of(const Rectangle& rectangle, int axis, const Domain& domain, double radius) {
  if (rectangle.lower[axis] <= domain.lower[axis] && rectangle.upper[axis] >= domain.upper[axis])
    return {.endless = true};
  return {.low = rectangle.lower[axis] - radius, .high = rectangle.upper[axis] + radius};
}

bool moves_along(const WallMotion& motion, int axis) {
  if (const auto* translating = std::get_if<Translating>(&motion)) return translating->velocity[axis] != 0.0;
  const auto* vibrating = std::get_if<Vibrating>(&motion);
  return vibrating != nullptr && vibrating->amplitude[axis] != 0.0;
}

void check_period(const Wall& wall, const Node& place, int axis, const Scene& scene) {
  const double radius = largest_radius(scene, true);
  const Domain& domain = scene.domain;
  const Reach reach = std::visit(
      Overloaded{[&](const Plane& plane) { return reach_of(plane, axis); },
                 [&](const Cylinder& cylinder) { return reach_of(cylinder, axis, radius); },
                 [&](const Rectangle& rectangle) { return reach_of(rectangle, axis, domain, radius); }},
      wall.shape);
  const bool rectangle = std::holds_alternative<Rectangle>(wall.shape);
  if (moves_along(wall.motion, axis) && (rectangle || !reach.endless))
    place.refuse("wall " + wall.name + " moving along a periodic axis", "a motion across it");
  if (std::holds_alternative<Plane>(wall.shape) && std::holds_alternative<Rotating>(wall.motion))
    place.refuse("wall " + wall.name + " turning in a periodic domain",
                 "a cylinder along the periodic axis, since a plane turns about one point");
  if (reach.endless) return;
  if (reach.beyond || reach.low < domain.lower[axis] || reach.high > domain.upper[axis])
    place.refuse("wall " + wall.name + " cut by a periodic face",
                 "a wall that is the same all along the periodic axis, or whose contacts stay within it");
}

void check_room(const Wall& wall, const Node& place, const Scene& scene) {
  const auto* cylinder = std::get_if<Cylinder>(&wall.shape);
  if (cylinder == nullptr || cylinder->side == Cylinder::Side::outside) return;
  const double radius = largest_radius(scene, true);
  if (cylinder->radius >= radius) return;
  place.table()
      .at("cylinder")
      .table()
      .at("radius")
      .refuse("a cylinder of radius " + shortest(cylinder->radius) + " m around a particle of radius " +
                  shortest(radius) + " m",
              "a cylinder that particles fit into");
}

}  // namespace

void check_walls(const SetUp& set_up) {
  const Scene& scene = set_up.scene;
  const std::size_t faces = scene.walls.size() - set_up.walls.size();
  for (std::size_t i = 0; i < set_up.walls.size(); ++i) {
    const Wall& wall = scene.walls[faces + i];
    check_room(wall, set_up.walls[i], scene);
    for (int axis = 0; axis < 3; ++axis)
      if (scene.domain.periodic(axis)) check_period(wall, set_up.walls[i], axis, scene);
  }
}

}  // namespace grainproof::input
