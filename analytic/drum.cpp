// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "analytic/one_on_wall.hpp"
#include "analytic/solution.hpp"

/// A sphere that slides in a turning drum, held where friction balances gravity, and is spun up there
/// until its surface is as fast as the drum's: walls.5 and walls.6.
namespace grainproof::analytic {
namespace {

constexpr double roundoff = 1e-9;  // of directions that are written in decimals

std::string why_not(const Scene& scene) {
  if (std::string because = why_not_one_on_wall(scene); !because.empty()) return because;
  const Wall& wall = scene.walls.front();
  const Particle& sphere = scene.particles.front();
  const auto* drum = std::get_if<Cylinder>(&wall.shape);
  if (!drum || drum->side != Cylinder::Side::inside) return "the wall is no drum";
  if (!std::holds_alternative<Rotating>(wall.motion)) return "the drum does not turn";
  const ContactLaws& laws = laws_on_wall(scene);
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
  const ContactLaws& laws = laws_on_wall(scene);
  const Vec3 offset = sphere.position - wall.point, out = offset - offset.dot(wall.axis) * wall.axis;
  const Vec3 outward = out.normalized(), carried = std::copysign(1.0, rate) * wall.axis.cross(outward);
  const Vec3& gravity = std::get<ConstantGravity>(scene.gravity).acceleration;
  const double mass = mass_on_wall(scene);
  const double push = gravity.dot(outward), mu = std::get<DynamicFriction>(laws.friction).coefficient;
  const Vec3 left = gravity - push * outward + mu * push * carried;
  if (!(push > 0.0) || left.norm() > roundoff * gravity.norm())
    return Solution::no("friction does not balance gravity where the sphere is");
  const double radius = 0.5 * sphere.diameter, overlap = out.norm() + radius - wall.radius;
  const double rest = mass * push / std::get<LinearNormal>(laws.normal).stiffness;
  if (const std::string because = why_not_at_rest(scene, mass * push, overlap); !because.empty())
    return Solution::no(because);
  const double spin_up = scene.rotation ? 2.5 * mu * push / radius : 0.0;
  if (spin_up * until * radius > std::abs(rate) * wall.radius * (1.0 - roundoff))
    return Solution::no("the sphere's surface becomes as fast as the drum's");
  Solution solution;
  const Vec3 turning = std::copysign(spin_up, rate) * wall.axis;
  solution.frame_at = [scene, turning](double time) {
    Frame frame = empty_frame(scene, time);
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
