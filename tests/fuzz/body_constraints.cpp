// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "model/strides.hpp"
#include "tests/fuzz/constraints.hpp"

namespace grainproof::fuzz {
namespace {

/// Shifts and turns of a sweep round positions.
constexpr double rounding = 1e-9;

bool positive(double x) {
  return std::isfinite(x) && x > 0.0;
}

bool inside(const Domain& domain, const Vec3& x) {
  return (x.array() >= domain.lower.array()).all() && (x.array() <= domain.upper.array()).all();
}

std::string broken_particle(const Scene& scene, const Particle& p) {
  if (p.material < 0 || p.material >= static_cast<std::int32_t>(scene.materials.size())) return "a material";
  if (!positive(p.diameter) || !positive(p.effect_diameter)) return "a diameter above 0";
  if (p.effect_diameter < p.diameter) return "an effect diameter not below the body's";
  const double mass = scene.materials[static_cast<std::size_t>(p.material)].density * std::pow(p.diameter, 3);
  if (!(mass >= 2.2250738585072014e-308) || !std::isfinite(mass)) return "a mass that is a number";
  if (!p.position.allFinite() || !inside(scene.domain, p.position)) return "a position inside the domain";
  if (!p.velocity.allFinite() || !p.angular_velocity.allFinite()) return "a finite velocity";
  if (p.fixed && !(p.velocity.isZero(0.0) && p.angular_velocity.isZero(0.0)))
    return "fixed particles at rest";
  if (!scene.rotation && !p.angular_velocity.isZero(0.0)) return "spins with rotation only";
  if (p.id < 1 || p.id > std::int64_t{1} << 53) return "ids from 1 to 2^53";
  if (may_leap(scene) && !(p.velocity.norm() * scene.run.step <= 0.5 * p.diameter * (1.0 + rounding)))
    return "a stride up to a radius";
  return "";
}

/// The least distance over all images.
double distance(const Domain& domain, const Vec3& a, const Vec3& b) {
  Vec3 apart = b - a;
  for (int axis = 0; axis < 3; ++axis) {
    const double period = domain.extent()[axis];
    if (domain.periodic(axis))
      for (const double shift : {-period, period})
        if (std::abs(apart[axis] + shift) < std::abs(apart[axis])) apart[axis] += shift;
  }
  return apart.norm();
}

std::string broken_pair(const Domain& domain, const Particle& a, const Particle& b) {
  if (a.id >= b.id) return "ids in order, each once";
  if (a.fixed && b.fixed) return "";
  const double overlap = 0.5 * (a.diameter + b.diameter) - distance(domain, a.position, b.position);
  const double limit = 0.25 * std::min(a.diameter, b.diameter);
  const double size = a.position.cwiseAbs().maxCoeff() + b.position.cwiseAbs().maxCoeff();
  return overlap <= limit * (1.0 + rounding) + 1e-15 * size ? "" : "no overlap above half the smaller radius";
}

double depth(const Wall& wall, const Particle& p) {
  const double radius = 0.5 * p.diameter;
  return std::visit(
      Overloaded{[&](const Plane& plane) { return radius - plane.normal.dot(p.position - plane.point); },
                 [&](const Cylinder& cylinder) {
                   const Vec3 from = p.position - cylinder.point;
                   const double off = (from - from.dot(cylinder.axis) * cylinder.axis).norm();
                   return cylinder.side == Cylinder::Side::inside ? radius - (cylinder.radius - off)
                                                                  : radius - (off - cylinder.radius);
                 },
                 [&](const Rectangle& flat) {
                   const Vec3 nearest = p.position.cwiseMax(flat.lower).cwiseMin(flat.upper);
                   return radius - (p.position - nearest).norm();
                 }},
      wall.shape);
}

std::string broken_shape(const Wall& wall) {
  if (const auto* plane = std::get_if<Plane>(&wall.shape))
    return plane->point.allFinite() && std::abs(plane->normal.norm() - 1.0) < rounding ? "" : "a unit normal";
  if (const auto* cylinder = std::get_if<Cylinder>(&wall.shape))
    return cylinder->point.allFinite() && std::abs(cylinder->axis.norm() - 1.0) < rounding &&
                   positive(cylinder->radius)
               ? ""
               : "a round cylinder";
  const auto& flat = std::get<Rectangle>(wall.shape);
  const Vec3 sides = flat.upper - flat.lower;
  return sides.allFinite() && (sides.array() >= 0.0).all() && (sides.array() == 0.0).count() == 1
             ? ""
             : "a flat rectangle";
}

std::string broken_motion(const Wall& wall) {
  const bool sound = std::visit(
      Overloaded{[](const Still&) { return true; },
                 [](const Translating& motion) { return motion.velocity.allFinite(); },
                 [&](const Rotating& motion) {
                   return std::isfinite(motion.rate) && !std::holds_alternative<Rectangle>(wall.shape);
                 },
                 [](const Vibrating& motion) {
                   return motion.amplitude.allFinite() && positive(motion.frequency) &&
                          std::isfinite(motion.phase);
                 }},
      wall.motion);
  return sound ? "" : "a sound motion of a wall";
}

}  // namespace

std::string broken_body(const Scene& scene) {
  for (const Particle& particle : scene.particles)
    if (std::string broken = broken_particle(scene, particle); !broken.empty()) return broken;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    for (std::size_t j = i + 1; j < scene.particles.size(); ++j)
      if (std::string broken = broken_pair(scene.domain, scene.particles[i], scene.particles[j]);
          !broken.empty())
        return broken;
  return "";
}

std::string broken_wall(const Scene& scene) {
  for (const Wall& wall : scene.walls) {
    if (wall.material < 0 || wall.material >= static_cast<std::int32_t>(scene.materials.size()))
      return "a material";
    if (std::string broken = broken_shape(wall); !broken.empty()) return broken;
    if (std::string broken = broken_motion(wall); !broken.empty()) return broken;
    for (const Particle& particle : scene.particles)
      if (!particle.fixed && !(depth(wall, particle) <= 0.25 * particle.diameter * (1.0 + rounding) +
                                                            1e-15 * particle.position.cwiseAbs().maxCoeff()))
        return "no particle deep in a wall";
  }
  return "";
}

}  // namespace grainproof::fuzz
