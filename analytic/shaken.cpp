// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "analytic/affine_motion.hpp"
#include "analytic/contact_scales.hpp"
#include "analytic/one_on_wall.hpp"
#include "analytic/solution.hpp"

/// A sphere that a plane vibrating along its normal shakes without ever letting go: walls.7. A driven,
/// damped vibration, solved with the drive's sine and cosine as states of their own.
namespace grainproof::analytic {
namespace {

enum { gap, rate, sine, cosine };

/// The wall's shift along its normal and its speed.
struct Drive {
  double amplitude, frequency, phase;  ///< m, rad/s, rad

  double shift(double time) const {
    return amplitude * (std::sin(frequency * time + phase) - std::sin(phase));
  }
  double speed(double time) const { return amplitude * frequency * std::cos(frequency * time + phase); }
};

struct Shaken {
  double mass, stiffness, damping, gravity;
  bool no_tension;
  Drive drive;

  /// walls.7.
  AffineMotion motion(double from, double velocity) const {
    Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
    a(gap, rate) = 1.0;
    a(rate, gap) = -stiffness / mass;
    a(rate, rate) = -damping / mass;
    a(rate, sine) = drive.amplitude * drive.frequency * drive.frequency;
    a(sine, cosine) = drive.frequency;
    a(cosine, sine) = -drive.frequency;
    const Eigen::Vector4d start(from, velocity - drive.speed(0.0), std::sin(drive.phase),
                                std::cos(drive.phase));
    return {a, Eigen::Vector4d(0.0, gravity, 0.0, 0.0), start};
  }

  bool pressed(const Eigen::VectorXd& s) const {
    return s[gap] < 0.0 && !(no_tension && stiffness * s[gap] + damping * s[rate] > 0.0);
  }

  double fastest() const { return std::max(std::sqrt(stiffness / mass), drive.frequency); }
};

std::string why_not(const Scene& scene) {
  if (std::string because = why_not_one_on_wall(scene); !because.empty()) return because;
  const Wall& wall = scene.walls.front();
  const Particle& sphere = scene.particles.front();
  if (!std::holds_alternative<Vibrating>(wall.motion)) return "the wall does not vibrate";
  if (!std::holds_alternative<Plane>(wall.shape)) return "the wall is no plane";
  const Vec3& normal = std::get<Plane>(wall.shape).normal;
  for (const Vec3& vector : {std::get<Vibrating>(wall.motion).amplitude, sphere.velocity,
                             sphere.angular_velocity, std::get<ConstantGravity>(scene.gravity).acceleration})
    if (vector.cross(normal).norm() > 1e-12 * vector.norm())
      return "something is not along the wall's normal";
  return "";
}

Shaken shaken_of(const Scene& scene, const Vec3& normal) {
  const auto& law = std::get<LinearNormal>(laws_on_wall(scene).normal);
  const double mass = mass_on_wall(scene);
  const auto& motion = std::get<Vibrating>(scene.walls[0].motion);
  return {mass,
          law.stiffness,
          damping(law, mass),
          std::get<ConstantGravity>(scene.gravity).acceleration.dot(normal),
          law.no_tension,
          {motion.amplitude.dot(normal), boost::math::constants::two_pi<double>() * motion.frequency,
           motion.phase}};
}

}  // namespace

Solution shaken(const Scene& scene, double until) {
  if (const std::string because = why_not(scene); !because.empty()) return Solution::no(because);
  const auto& plane = std::get<Plane>(scene.walls.front().shape);
  const Particle sphere = scene.particles.front();
  const Shaken law = shaken_of(scene, plane.normal);
  if (!(until * law.fastest() < 1e5)) return Solution::no("the run holds more than 1e5 vibrations");
  const double from = (sphere.position - plane.point).dot(plane.normal) - 0.5 * sphere.diameter;
  const AffineMotion motion = law.motion(from, sphere.velocity.dot(plane.normal));
  for (double time = 0.0; time < until; time += 0.1 / law.fastest())
    if (!law.pressed(motion.at(time))) return Solution::no("the sphere does not stay on the wall");
  Solution solution;
  solution.frame_at = [scene, sphere, law, motion, from, normal = plane.normal](double time) {
    const Eigen::VectorXd s = motion.at(time);
    Frame frame = empty_frame(scene, time);
    frame.position.push_back(sphere.position + (s[gap] - from + law.drive.shift(time)) * normal);
    frame.velocity.push_back((s[rate] + law.drive.speed(time)) * normal);
    if (scene.rotation) frame.angular_velocity.push_back(sphere.angular_velocity);
    return frame;
  };
  return solution;
}

}  // namespace grainproof::analytic
