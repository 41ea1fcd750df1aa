// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/supports.hpp"

#include <array>
#include <sstream>
#include <string>

#include "reference_cpu/bodies.hpp"

namespace grainproof::reference {
namespace {

constexpr std::array<char, 3> axis_names{'x', 'y', 'z'};

/// A pair may touch through one image only, so a period holds two of the largest ranges.
Support periods_hold_two_ranges(const Scene& scene) {
  const double range = 2.0 * largest_reach(scene);
  for (int axis = 0; axis < 3; ++axis) {
    const double period = scene.domain.extent()[axis];
    if (!scene.domain.periodic(axis) || period >= 2.0 * range) continue;
    std::ostringstream why;
    why << "the periodic box is too small for its particles: " << period << " m along " << axis_names[axis]
        << "; it must be at least " << 2.0 * range << " m, twice the range of the largest pair";
    return Support::no(why.str());
  }
  return {};
}

/// A plane has no image of itself that fits.
bool fits_period(const Plane& plane, int axis, const Domain&, double) {
  return plane.normal[axis] == 0.0;
}

/// A rectangle either spans the period or leaves room.
bool fits_period(const Rectangle& rectangle, int axis, const Domain& domain, double range) {
  const double period = domain.extent()[axis], length = rectangle.upper[axis] - rectangle.lower[axis];
  return length >= period || period - length >= range;
}

/// A cylinder lies along the axis, or across it with all its contacts within the period.
bool fits_period(const Cylinder& cylinder, int axis, const Domain& domain, double range) {
  if (cylinder.axis.cwiseAbs() == Vec3::Unit(axis)) return true;
  const double around = cylinder.radius + (cylinder.side == Cylinder::Side::outside ? 0.5 * range : 0.0);
  const double centre = cylinder.point[axis];
  return cylinder.axis[axis] == 0.0 && centre - around >= domain.lower[axis] &&
         centre + around <= domain.upper[axis];
}

/// Within its period a cylinder must stay.
bool stays(const Wall& wall, int axis) {
  const auto* cylinder = std::get_if<Cylinder>(&wall.shape);
  if (!cylinder || cylinder->axis[axis] != 0.0) return true;
  return std::visit(Overloaded{[&](const Translating& motion) { return motion.velocity[axis] == 0.0; },
                               [&](const Vibrating& motion) { return motion.amplitude[axis] == 0.0; },
                               [](const auto&) { return true; }},
                    wall.motion);
}

Support walls_fit_periods(const Scene& scene) {
  const double range = 2.0 * largest_reach(scene);
  for (const Wall& wall : scene.walls)
    for (int axis = 0; axis < 3; ++axis) {
      if (!scene.domain.periodic(axis)) continue;
      const auto fits = [&](const auto& shape) { return fits_period(shape, axis, scene.domain, range); };
      if (std::visit(fits, wall.shape) && stays(wall, axis)) continue;
      return Support::no(
          "the wall '" + wall.name + "' does not fit the periodic " + axis_names[axis] +
          " axis: a plane must lie along it, a rectangle span it or leave a gap as wide as the largest "
          "particle, a cylinder lie along it or across it with its contacts within the period, "
          "where it must stay");
    }
  return {};
}

Support fixed_particles_rest(const Scene& scene) {
  for (const Particle& particle : scene.particles)
    if (particle.fixed && (particle.velocity != Vec3::Zero() || particle.angular_velocity != Vec3::Zero()))
      return Support::no("the fixed particle " + std::to_string(particle.id) + " has a velocity");
  return {};
}

Support turning_is_asked_for(const Scene& scene) {
  if (scene.rotation) return {};
  for (const Particle& particle : scene.particles)
    if (particle.angular_velocity != Vec3::Zero())
      return Support::no("particle " + std::to_string(particle.id) +
                         " has an angular velocity in a scene without rotation");
  return {};
}

Support walls_can_turn(const Scene& scene) {
  const bool periodic = scene.domain.periodic(0) || scene.domain.periodic(1) || scene.domain.periodic(2);
  for (const Wall& wall : scene.walls) {
    if (!std::holds_alternative<Rotating>(wall.motion)) continue;
    if (std::holds_alternative<Rectangle>(wall.shape))
      return Support::no("the wall '" + wall.name + "' cannot turn: a rectangle has no turn within itself");
    if (std::holds_alternative<Plane>(wall.shape) && periodic)
      return Support::no("the wall '" + wall.name +
                         "' cannot turn: the surface of a turning plane has no period");
  }
  return {};
}

Support cylinders_hold_particles(const Scene& scene) {
  for (const Wall& wall : scene.walls) {
    const auto* cylinder = std::get_if<Cylinder>(&wall.shape);
    if (cylinder && cylinder->side == Cylinder::Side::inside && cylinder->radius <= largest_reach(scene))
      return Support::no("the largest particle does not fit into the cylinder '" + wall.name + "'");
  }
  return {};
}

Support orientations_turn(const Scene& scene) {
  if (scene.orientation != OrientationUpdate::none && !scene.rotation)
    return Support::no("orientations need a scene with rotation");
  return {};
}

}  // namespace

Support supported(const Scene& scene) {
  for (const auto& check :
       {laws_supported, periods_hold_two_ranges, walls_fit_periods, walls_can_turn, cylinders_hold_particles,
        fixed_particles_rest, turning_is_asked_for, orientations_turn, memories_supported})
    if (const Support support = check(scene); !support) return support;
  return {};
}

}  // namespace grainproof::reference
