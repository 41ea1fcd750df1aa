// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/affine_motion.hpp"
#include "analytic/contact_scales.hpp"
#include "analytic/one_on_wall.hpp"
#include "analytic/solution.hpp"

/// A sphere that friction's spring makes roll on a plane that turns about its normal: walls.8 and walls.9.
namespace grainproof::analytic {
namespace {

/// Two components each along the plane: place against the plane's point, velocity, r ω × n, and spring.
enum { place = 0, velocity = 2, surface = 4, spring = 6, states = 8 };

struct Table {
  Vec3 normal, one, other;  ///< a right-handed frame
  double mass, radius, rate;
  double stiffness, damping, limit;  ///< of friction: N/m, N s/m, N

  using Row = Eigen::Matrix<double, 2, states>;

  Row slip() const {
    Row row = Row::Zero();
    row.block<2, 2>(0, velocity).setIdentity();
    row.block<2, 2>(0, surface) = -Eigen::Matrix2d::Identity();
    row(0, place + 1) = rate;
    row(1, place) = -rate;
    return row;
  }

  Row friction() const {
    Row row = -damping * slip();
    row.block<2, 2>(0, spring) -= stiffness * Eigen::Matrix2d::Identity();
    return row;
  }

  /// walls.8.
  AffineMotion motion(const Eigen::VectorXd& start) const {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(states, states);
    a.block<2, 2>(place, velocity).setIdentity();
    a.middleRows<2>(velocity) = friction() / mass;
    a.middleRows<2>(surface) = -2.5 / mass * friction();
    a.middleRows<2>(spring) = slip();
    return {a, Eigen::VectorXd::Zero(states), start};
  }

  Eigen::Vector2d along(const Vec3& vector) const { return {vector.dot(one), vector.dot(other)}; }
  Vec3 in_space(const Eigen::Vector2d& vector) const { return vector.x() * one + vector.y() * other; }
  double fastest() const { return std::sqrt(3.5 * stiffness / mass) + std::abs(rate); }
};

std::string why_not(const Scene& scene) {
  if (std::string because = why_not_one_on_wall(scene); !because.empty()) return because;
  const Wall& wall = scene.walls.front();
  if (!std::holds_alternative<Plane>(wall.shape) || !std::holds_alternative<Rotating>(wall.motion))
    return "the wall is no plane that turns";
  if (!scene.rotation) return "nothing turns in this scene";
  if (!scene.remembered.empty()) return "contacts remember something at the start";
  const ContactLaws& laws = laws_on_wall(scene);
  if (!std::holds_alternative<NoRolling>(laws.rolling)) return "rolling is resisted";
  const auto* history = std::get_if<HistoryFriction>(&laws.friction);
  if (!history) return "the friction has no spring";
  return history->arm == TorqueArm::radius ? "" : "the torque arm changes with the overlap";
}

Table table_of(const Scene& scene) {
  const Particle& sphere = scene.particles.front();
  const Wall& wall = scene.walls.front();
  const ContactLaws& laws = laws_on_wall(scene);
  const auto& history = std::get<HistoryFriction>(laws.friction);
  const Vec3& normal = std::get<Plane>(wall.shape).normal;
  const Vec3 one = normal.unitOrthogonal();
  const double mass = mass_on_wall(scene);
  const double weight = -mass * std::get<ConstantGravity>(scene.gravity).acceleration.dot(normal);
  return {normal,
          one,
          normal.cross(one),
          mass,
          0.5 * sphere.diameter,
          std::get<Rotating>(wall.motion).rate,
          history.stiffness,
          history.damping_ratio * damping(std::get<LinearNormal>(laws.normal), mass),
          history.coefficient * weight};
}

std::string why_not_resting(const Scene& scene, const Table& table) {
  const Particle& sphere = scene.particles.front();
  const auto& plane = std::get<Plane>(scene.walls[0].shape);
  const Vec3& gravity = std::get<ConstantGravity>(scene.gravity).acceleration;
  const double weight = -table.mass * gravity.dot(plane.normal);
  if (!(weight > 0.0) || gravity.cross(plane.normal).norm() > 1e-12 * gravity.norm())
    return "gravity does not press the sphere on the plane";
  const double overlap = table.radius - (sphere.position - plane.point).dot(plane.normal);
  if (std::string because = why_not_at_rest(scene, weight, overlap); !because.empty()) return because;
  return sphere.velocity.dot(plane.normal) == 0.0 ? "" : "the sphere starts with a velocity along the normal";
}

}  // namespace

Solution turntable(const Scene& scene, double until) {
  if (const std::string because = why_not(scene); !because.empty()) return Solution::no(because);
  const Table table = table_of(scene);
  if (const std::string because = why_not_resting(scene, table); !because.empty())
    return Solution::no(because);
  if (!(until * table.fastest() < 1e4)) return Solution::no("the run holds more than 1e4 vibrations");
  const Particle sphere = scene.particles.front();
  const Vec3 centre = std::get<Plane>(scene.walls[0].shape).point;
  Eigen::VectorXd start = Eigen::VectorXd::Zero(states);
  start.segment<2>(place) = table.along(sphere.position - centre);
  start.segment<2>(velocity) = table.along(sphere.velocity);
  start.segment<2>(surface) = table.radius * table.along(sphere.angular_velocity.cross(table.normal));
  const AffineMotion motion = table.motion(start);
  for (double time = 0.0; time < until; time += 0.1 / table.fastest())
    if ((table.friction() * motion.at(time)).norm() >= table.limit)
      return Solution::no("friction reaches its limit");
  Solution solution;
  solution.frame_at = [=](double time) {
    const Eigen::VectorXd s = motion.at(time);
    const Vec3 turning = table.normal.cross(table.in_space(s.segment<2>(surface))) / table.radius;
    Frame frame = empty_frame(scene, time);
    frame.position.push_back(sphere.position + table.in_space(s.segment<2>(place) - start.segment<2>(place)));
    frame.velocity.push_back(table.in_space(s.segment<2>(velocity)));
    frame.angular_velocity.push_back(turning + sphere.angular_velocity.dot(table.normal) * table.normal);
    return frame;
  };
  return solution;
}

}  // namespace grainproof::analytic
