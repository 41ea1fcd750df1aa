// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/transforms.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "input/uniform.hpp"

namespace grainproof::input {
namespace {

Rotation random_rotation(Uniform& uniform) {
  const double part = uniform();
  const double first = 2.0 * std::numbers::pi * uniform();
  const double second = 2.0 * std::numbers::pi * uniform();
  const double a = std::sqrt(1.0 - part);
  const double b = std::sqrt(part);
  return Eigen::Quaterniond(b * std::cos(second), a * std::sin(first), a * std::cos(first),
                            b * std::sin(second))
      .normalized()
      .toRotationMatrix();
}

void refuse_unrotatable(const Scene& scene, const Node& place) {
  for (const Boundary boundary : scene.domain.boundary)
    if (boundary != Boundary::open) place.refuse("orientation in a domain that is not open", "open faces");
  for (const Wall& wall : scene.walls)
    if (std::holds_alternative<Rectangle>(wall.shape))
      place.refuse("orientation with the rectangle " + wall.name,
                   "planes and cylinders, which can be turned");
  if (std::holds_alternative<RotatingGravity>(scene.gravity) ||
      std::holds_alternative<TaylorGreenFlow>(scene.flow))
    place.refuse("orientation with a field that is bound to the axes",
                 "constant or central gravity, uniform flow");
}

}  // namespace

std::vector<Rotation> rotations_of(const Sweep& sweep) {
  if (!sweep.orientations) return {Rotation::Identity()};
  Uniform uniform(sweep.orientations->seed);
  std::vector<Rotation> out;
  for (int i = 0; i < sweep.rotations(); ++i) out.push_back(random_rotation(uniform));
  return out;
}

double dither(int sample) {
  constexpr double golden = std::numbers::phi - 1.0;
  const double multiple = (sample + 0.5) * golden;
  return multiple - std::floor(multiple) - 0.5;
}

void shift(Scene& scene, const Vec3& offset, const Node& place) {
  if (std::holds_alternative<TaylorGreenFlow>(scene.flow))
    place.refuse("offset with a flow that is bound to the origin", "no flow, or a uniform one");
  scene.domain.lower += offset;
  scene.domain.upper += offset;
  for (Particle& particle : scene.particles) particle.position += offset;
  for (Wall& wall : scene.walls)
    std::visit(Overloaded{[&](Plane& plane) { plane.point += offset; },
                          [&](Cylinder& cylinder) { cylinder.point += offset; },
                          [&](Rectangle& rectangle) {
                            rectangle.lower += offset;
                            rectangle.upper += offset;
                          }},
               wall.shape);
  if (auto* central = std::get_if<CentralGravity>(&scene.gravity)) central->centre += offset;
}

void rotate(Scene& scene, const Rotation& rotation, const Node& place) {
  refuse_unrotatable(scene, place);
  const Vec3 centre = scene.domain.lower + 0.5 * scene.domain.extent();
  const auto turned = [&](const Vec3& point) -> Vec3 { return centre + rotation * (point - centre); };
  for (Particle& particle : scene.particles) {
    particle.position = turned(particle.position);
    particle.velocity = rotation * particle.velocity;
    particle.angular_velocity = rotation * particle.angular_velocity;
  }
  for (Wall& wall : scene.walls) {
    if (auto* plane = std::get_if<Plane>(&wall.shape))
      *plane = {turned(plane->point), (rotation * plane->normal).normalized()};
    if (auto* cylinder = std::get_if<Cylinder>(&wall.shape)) {
      cylinder->point = turned(cylinder->point);
      cylinder->axis = (rotation * cylinder->axis).normalized();
    }
    if (auto* translating = std::get_if<Translating>(&wall.motion))
      translating->velocity = rotation * translating->velocity;
    if (auto* vibrating = std::get_if<Vibrating>(&wall.motion))
      vibrating->amplitude = rotation * vibrating->amplitude;
  }
  if (auto* constant = std::get_if<ConstantGravity>(&scene.gravity))
    constant->acceleration = rotation * constant->acceleration;
  if (auto* central = std::get_if<CentralGravity>(&scene.gravity)) central->centre = turned(central->centre);
  if (auto* flow = std::get_if<UniformFlow>(&scene.flow)) flow->velocity = rotation * flow->velocity;
}

void start_earlier(Scene& scene, double time) {
  for (Particle& particle : scene.particles)
    if (!particle.fixed) particle.position -= time * particle.velocity;
}

void check_still_inside(const Scene& scene, const Node& place) {
  for (const Particle& particle : scene.particles) {
    const auto x = particle.position.array();
    if ((x >= scene.domain.lower.array()).all() && (x <= scene.domain.upper.array()).all()) continue;
    place.refuse("particle " + std::to_string(particle.id) + " outside the domain once " +
                     std::string(place.name()) + " is applied",
                 "a domain that still holds it");
  }
}

}  // namespace grainproof::input
