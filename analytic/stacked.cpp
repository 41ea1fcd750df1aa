// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include "analytic/affine_motion.hpp"
#include "analytic/contact_scales.hpp"
#include "analytic/solution.hpp"

/// Two spheres pressed together between two parallel walls, moving along one line and never parting:
/// linear.12. One linear system of four, solved by the exponential of its matrix.
namespace grainproof::analytic {
namespace {

enum { first, second, first_speed, second_speed };

/// A contact's force as (stiffness, damping) times an overlap and its rate.
struct Spring {
  double stiffness;
  double damping;
};

/// Along the first wall's normal, from that wall: two centres and the other wall.
struct Column {
  Vec3 axis = Vec3::Zero();
  std::size_t lower = 0, upper = 1;  ///< particles
  double height = 0.0;               ///< distance of the walls, m
  double gravity = 0.0;
  double mass[2]{}, radius[2]{};
  Spring floor{}, middle{}, ceiling{};
  Eigen::Vector4d start = Eigen::Vector4d::Zero();

  double overlap_floor(const Eigen::VectorXd& s) const { return radius[0] - s[first]; }
  double overlap_middle(const Eigen::VectorXd& s) const {
    return radius[0] + radius[1] - (s[second] - s[first]);
  }
  double overlap_ceiling(const Eigen::VectorXd& s) const { return radius[1] - (height - s[second]); }

  /// linear.12.
  AffineMotion motion() const {
    Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
    a(first, first_speed) = a(second, second_speed) = 1.0;
    const auto couple = [&](int row, double sign, double mass_of, const Spring& spring, int position) {
      a(row, position) += sign * spring.stiffness / mass_of;
      a(row, position + 2) += sign * spring.damping / mass_of;
    };
    couple(first_speed, -1.0, mass[0], floor, first);
    couple(first_speed, -1.0, mass[0], middle, first);
    couple(first_speed, 1.0, mass[0], middle, second);
    couple(second_speed, 1.0, mass[1], middle, first);
    couple(second_speed, -1.0, mass[1], middle, second);
    couple(second_speed, -1.0, mass[1], ceiling, second);
    const double touching = radius[0] + radius[1];
    Eigen::Vector4d b(0.0, 0.0, 0.0, 0.0);
    b[first_speed] = gravity + (floor.stiffness * radius[0] - middle.stiffness * touching) / mass[0];
    b[second_speed] =
        gravity + (middle.stiffness * touching + ceiling.stiffness * (height - radius[1])) / mass[1];
    return {a, b, start};
  }

  double fastest() const {
    return std::sqrt((floor.stiffness + 2.0 * middle.stiffness + ceiling.stiffness) /
                     std::min(mass[0], mass[1]));
  }
};

struct Stack {
  std::string because;
  Column column;
};

/// The spring between two materials; none where the law is not linear or may be clamped.
std::optional<Spring> spring_of(const Scene& scene, std::size_t a, std::size_t b, double mass) {
  if (!scene.contacts.has(a, b)) return std::nullopt;
  const ContactLaws& laws = scene.contacts.at(a, b);
  const auto* linear = std::get_if<LinearNormal>(&laws.normal);
  if (!linear || linear->no_tension || !std::holds_alternative<NoCohesion>(laws.cohesion))
    return std::nullopt;
  return Spring{linear->stiffness, damping(*linear, mass)};
}

std::string why_not(const Scene& scene) {
  if (scene.particles.size() != 2 || scene.walls.size() != 2)
    return "there are not two particles and two walls";
  if (scene.particles[0].fixed || scene.particles[1].fixed) return "a particle is fixed";
  if (!std::holds_alternative<NoFlow>(scene.flow)) return "a fluid acts on the particles";
  if (!std::holds_alternative<ConstantGravity>(scene.gravity)) return "gravity is not constant";
  if (scene.rotation) return "the bodies turn";
  for (const Wall& wall : scene.walls)
    if (!std::holds_alternative<Plane>(wall.shape) || !std::holds_alternative<Still>(wall.motion))
      return "a wall is no plane at rest";
  const auto& floor = std::get<Plane>(scene.walls[0].shape);
  const auto& ceiling = std::get<Plane>(scene.walls[1].shape);
  return (floor.normal + ceiling.normal).isZero(1e-12) ? "" : "the two walls do not face each other";
}

bool along(const Vec3& vector, const Vec3& axis) {
  return vector.cross(axis).norm() <= 1e-12 * vector.norm();
}

Stack stack_of(const Scene& scene) {
  if (std::string because = why_not(scene); !because.empty()) return {because, {}};
  Column c;
  const auto& floor = std::get<Plane>(scene.walls[0].shape);
  c.axis = floor.normal;
  const auto up = [&](const Vec3& point) { return (point - floor.point).dot(c.axis); };
  if (up(scene.particles[0].position) > up(scene.particles[1].position)) std::swap(c.lower, c.upper);
  const Particle& one = scene.particles[c.lower];
  const Particle& two = scene.particles[c.upper];
  const Vec3& gravity = std::get<ConstantGravity>(scene.gravity).acceleration;
  for (const Vec3& vector : {Vec3(two.position - one.position), one.velocity, two.velocity, gravity})
    if (!along(vector, c.axis)) return {"something is not along the walls' normal", {}};
  c.height = up(std::get<Plane>(scene.walls[1].shape).point);
  c.gravity = gravity.dot(c.axis);
  for (const int i : {0, 1}) {
    const Particle& particle = i == 0 ? one : two;
    c.mass[i] = sphere_mass(scene.materials[particle.material].density, particle.diameter);
    c.radius[i] = 0.5 * particle.diameter;
  }
  c.start << up(one.position), up(two.position), one.velocity.dot(c.axis), two.velocity.dot(c.axis);
  const auto bottom = spring_of(scene, one.material, scene.walls[0].material, c.mass[0]);
  const auto middle = spring_of(scene, one.material, two.material, effective_mass(c.mass[0], c.mass[1]));
  const auto top = spring_of(scene, two.material, scene.walls[1].material, c.mass[1]);
  if (!bottom || !middle || !top) return {"a contact is not linear, or clamped, or coheres", {}};
  c.floor = *bottom, c.middle = *middle, c.ceiling = *top;
  return {"", c};
}

bool pressed(const Column& column, const AffineMotion& motion, double until) {
  const double step = 0.1 / column.fastest();
  for (double time = 0.0; time < until; time += step) {
    const Eigen::VectorXd s = motion.at(time);
    if (!(column.overlap_floor(s) > 0.0 && column.overlap_middle(s) > 0.0 && column.overlap_ceiling(s) > 0.0))
      return false;
  }
  return true;
}

}  // namespace

Solution stacked(const Scene& scene, double until) {
  const Stack found = stack_of(scene);
  if (!found.because.empty()) return Solution::no(found.because);
  const Column& column = found.column;
  if (!(until * column.fastest() < 1e4)) return Solution::no("the run holds more than 1e4 vibrations");
  const AffineMotion motion = column.motion();
  if (!pressed(column, motion, until)) return Solution::no("the bodies do not stay pressed together");
  Solution solution;
  solution.frame_at = [scene, column, motion](double time) {
    const Eigen::VectorXd s = motion.at(time);
    Frame frame = empty_frame(scene, time);
    for (const Particle& particle : scene.particles) {
      const int i = particle.id == scene.particles[column.lower].id ? first : second;
      frame.position.push_back(particle.position + (s[i] - column.start[i]) * column.axis);
      frame.velocity.push_back(s[i + 2] * column.axis);
    }
    return frame;
  };
  return solution;
}

}  // namespace grainproof::analytic
