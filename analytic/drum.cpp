// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "analytic/contact_scales.hpp"
#include "analytic/solution.hpp"

/// A sphere that slides in a turning drum, held where friction balances gravity, and is spun up there
/// until its surface is as fast as the drum's: walls.5 and walls.6.
namespace grainproof::analytic {
namespace {

constexpr double roundoff = 1e-9;  // of directions and overlaps that are written in decimals

std::string why_not(const Scene& scene) {
  if (scene.particles.size() != 1 || scene.walls.size() != 1) return "there is not one particle and one wall";
  const Wall& wall = scene.walls.front();
  const Particle& sphere = scene.particles.front();
  const auto* drum = std::get_if<Cylinder>(&wall.shape);
  if (!drum || drum->side != Cylinder::Side::inside) return "the wall is no drum";
  if (!std::holds_alternative<Rotating>(wall.motion)) return "the drum does not turn";
  if (sphere.fixed) return "nothing moves";
  if (!std::holds_alternative<NoFlow>(scene.flow)) return "a fluid acts on the particle";
  if (!std::holds_alternative<ConstantGravity>(scene.gravity)) return "gravity is not constant";
  if (scene.orientation != OrientationUpdate::none) return "orientations are asked for";
  if (!scene.contacts.has(sphere.material, wall.material))
    return "the sphere and the wall have no contact laws";
  const ContactLaws& laws = scene.contacts.at(sphere.material, wall.material);
  if (!std::holds_alternative<LinearNormal>(laws.normal)) return "the contact is not linear";
  if (!std::holds_alternative<NoCohesion>(laws.cohesion)) return "cohesion acts";
  if (!std::holds_alternative<NoRolling>(laws.rolling)) return "rolling is resisted";
  if (!std::holds_alternative<DynamicFriction>(laws.friction)) return "the friction is not dynamic";
  return sphere.velocity.isZero(0.0) && sphere.angular_velocity.isZero(0.0) ? ""
                                                                            : "the sphere moves at the start";
}

}  // namespace

Solution drum(const Scene& scene, double until) {
  if (const std::string because = why_not(scene); !because.empty()) return Solution::no(because);
  const Particle& sphere = scene.particles.front();
  const auto& wall = std::get<Cylinder>(scene.walls[0].shape);
  const double rate = std::get<Rotating>(scene.walls[0].motion).rate;
  const ContactLaws& laws = scene.contacts.at(sphere.material, scene.walls[0].material);
  const Vec3 offset = sphere.position - wall.point, out = offset - offset.dot(wall.axis) * wall.axis;
  const Vec3 outward = out.normalized(), carried = std::copysign(1.0, rate) * wall.axis.cross(outward);
  const Vec3& gravity = std::get<ConstantGravity>(scene.gravity).acceleration;
  const double mass = sphere_mass(scene.materials[sphere.material].density, sphere.diameter);
  const double push = gravity.dot(outward), mu = std::get<DynamicFriction>(laws.friction).coefficient;
  const Vec3 left = gravity - push * outward + mu * push * carried;
  if (!(push > 0.0) || left.norm() > roundoff * gravity.norm())
    return Solution::no("friction does not balance gravity where the sphere is");
  const double radius = 0.5 * sphere.diameter, overlap = out.norm() + radius - wall.radius;
  const double rest = mass * push / std::get<LinearNormal>(laws.normal).stiffness;
  if (std::abs(overlap - rest) > roundoff * rest)
    return Solution::no("the sphere doesn't start at its resting overlap");
  const double spin_up = scene.rotation ? 2.5 * mu * push / radius : 0.0;
  if (spin_up * until * radius > std::abs(rate) * wall.radius * (1.0 - roundoff))
    return Solution::no("the sphere's surface becomes as fast as the drum's");
  Solution solution;
  const Vec3 turning = std::copysign(spin_up, rate) * wall.axis;
  solution.frame_at = [scene, turning](double time) {
    Frame frame;
    frame.step = step_at_or_after(time, scene.run.step);
    frame.time = time;
    frame.position.push_back(scene.particles.front().position);
    frame.velocity.push_back(Vec3::Zero());
    if (scene.rotation) frame.angular_velocity.push_back(time * turning);
    return frame;
  };
  const double friction = mass * mu * push, arm = wall.radius;  // it acts where the surface is
  solution.scalars = {{"resting_overlap", rest},
                      {"wall_impulse:0", mass * gravity.norm() * until},
                      {"wall_angular_impulse:0", friction * arm * until},
                      {"wall_work", friction * arm * std::abs(rate) * until}};
  return solution;
}

}  // namespace grainproof::analytic
