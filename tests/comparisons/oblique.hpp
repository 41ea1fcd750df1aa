// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/comparisons/scenes.hpp"

/// One contact with history friction, integrated here and by nobody else: what a peer must reproduce.
namespace grainproof::test {

struct Oblique {
  Scene scene;
  HistoryFriction friction;
  bool wall = false;  ///< the first body is the plane x = 0, whose normal is +x

  struct Body {
    Vec3 x, v, w;
    double r, inverse_mass, inverse_inertia;
  };
  struct Load {
    Vec3 force, torque_1, torque_2;  ///< force on the second body
  };

  std::array<Body, 2> bodies{};
  Vec3 spring = Vec3::Zero();
  Vec3 rolling = Vec3::Zero();  ///< torque on the first body

  explicit Oblique(Scene given) : scene(std::move(given)), wall(!scene.walls.empty()) {
    friction = std::get<HistoryFriction>(scene.contacts.at(0, 0).friction);
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      const Particle& p = scene.particles[i];
      const double m = mass(p.diameter);
      bodies[wall ? 1 : i] = {p.position,
                              p.velocity,
                              p.angular_velocity,
                              0.5 * p.diameter,
                              p.fixed ? 0.0 : 1.0 / m,
                              p.fixed || !scene.rotation ? 0.0 : 10.0 / (m * p.diameter * p.diameter)};
    }
  }

  /// k_n δ, k_t and both dashpots at an overlap.
  struct Stiffness {
    double elastic, tangential, damping, tangential_damping;
  };

  Stiffness linear(const LinearNormal& law, double overlap) const {
    const double m = 1.0 / (bodies[0].inverse_mass + bodies[1].inverse_mass);
    const auto* given = std::get_if<Damping>(&law.dissipation);
    const auto* share = std::get_if<DampingRatio>(&law.dissipation);
    const double e = given || share ? 1.0 : std::get<Restitution>(law.dissipation).value;
    const double eta = given     ? given->value
                       : share   ? 2.0 * share->value * std::sqrt(m * law.stiffness)
                       : e < 1.0 ? dashpot(e, m, law.stiffness)
                                 : 0.0;
    return {law.stiffness * overlap, friction.stiffness, eta, friction.damping_ratio * eta};
  }

  /// Hertz and Mindlin with like materials: E* = E/(2(1 − ν²)), G* = E/(4(2 − ν)(1 + ν)).
  Stiffness hertz(const HertzNormal& law, double overlap) const {
    const auto [E, nu] = *scene.materials[0].elasticity;
    const double m = 1.0 / (bodies[0].inverse_mass + bodies[1].inverse_mass);
    const double root = std::sqrt(effective_radius() * overlap);
    const double kn = E / (1.0 - nu * nu) * root;
    const double kt = 2.0 * E / ((2.0 - nu) * (1.0 + nu)) * root;
    const auto* share = std::get_if<DampingRatio>(&law.dissipation);
    const double e = share ? 0.0 : std::log(std::get<Restitution>(law.dissipation).value);
    const double tsuji =
        share ? 2.0 * share->value : -2.0 * std::sqrt(5.0 / 6.0) * e / std::hypot(e, std::numbers::pi);
    return {2.0 / 3.0 * kn * overlap, kt, tsuji * std::sqrt(m * kn),
            friction.damping_ratio * tsuji * std::sqrt(m * kt)};
  }

  double effective_radius() const {
    return wall ? bodies[1].r : bodies[0].r * bodies[1].r / (bodies[0].r + bodies[1].r);
  }

  Stiffness stiffness_at(double overlap) const {
    const NormalLaw& law = scene.contacts.at(0, 0).normal;
    if (const auto* hertzian = std::get_if<HertzNormal>(&law)) return hertz(*hertzian, overlap);
    return linear(std::get<LinearNormal>(law), overlap);
  }

  void turn(const Vec3& n) {
    const double before = spring.norm();
    spring -= spring.dot(n) * n;
    if (friction.turn == SpringTurn::project_and_rescale && before > 0.0) spring *= before / spring.norm();
  }

  Vec3 tangential(const Stiffness& k, const Vec3& slip, double limit) {
    const Vec3 dashpot_force = -k.tangential_damping * slip;
    Vec3 force = -k.tangential * spring;
    if (friction.limit == CoulombLimit::spring_and_dashpot) force += dashpot_force;
    const bool slides = force.norm() > limit;
    if (slides) {
      force *= limit / force.norm();
      spring = -(friction.limit == CoulombLimit::spring ? force : Vec3(force - dashpot_force)) / k.tangential;
    } else if (friction.limit == CoulombLimit::spring) {
      force += dashpot_force;
    }
    return force;
  }

  /// docs/laws/rolling.md, as LIGGGHTS has it: at a wall the rolling spring is stretched by the spin times
  /// arm over distance. `advanced` is the time it is stretched for; returns the torque on the first.
  Vec3 roll(const Stiffness& k, const Vec3& n, double push, double overlap, double advanced) {
    const Vec3 spin = wall ? Vec3(-bodies[1].w) : Vec3(bodies[0].w - bodies[1].w);
    const Vec3 across = spin - spin.dot(n) * n;
    const double radius = effective_radius();
    const RollingLaw& law = scene.contacts.at(0, 0).rolling;
    if (const auto* constant = std::get_if<ConstantTorqueRolling>(&law))
      return -constant->coefficient * radius * k.elastic / spin.norm() * across;
    if (const auto* elastic = std::get_if<SpringRolling>(&law)) {
      const double r = bodies[1].r;
      const double factor = wall ? (r - 0.5 * overlap) / (r - overlap) : 1.0;
      rolling -= factor * k.tangential * radius * radius * advanced * across;
      const double limit = elastic->coefficient * radius * std::abs(push);
      if (rolling.norm() > limit) rolling *= limit / rolling.norm();
      return rolling;
    }
    return Vec3::Zero();
  }

  Load load(double advanced) {
    Body& one = bodies[0];
    Body& two = bodies[1];
    const Vec3 apart = wall ? Vec3(two.x.x(), 0.0, 0.0) : Vec3(two.x - one.x);
    const double distance = apart.norm();
    const double overlap = (wall ? 0.0 : one.r) + two.r - distance;
    if (overlap <= 0.0) {
      spring.setZero();
      rolling.setZero();
      return {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    }
    const Vec3 n = apart / distance;
    const double cut = friction.arm == TorqueArm::overlap ? 0.5 * overlap : 0.0;
    const double arm_1 = wall ? 0.0 : one.r - cut;
    const double arm_2 = two.r - cut;
    const Vec3 u = two.v - one.v - (arm_2 * two.w + arm_1 * one.w).cross(n);
    const Vec3 slip = u - u.dot(n) * n;
    turn(n);
    spring += advanced * slip;
    const Stiffness k = stiffness_at(overlap);
    double push = k.elastic - k.damping * u.dot(n);
    const auto* normal_law = std::get_if<LinearNormal>(&scene.contacts.at(0, 0).normal);
    if (normal_law && normal_law->no_tension) push = std::max(push, 0.0);
    const Vec3 pull = tangential(k, slip, friction.coefficient * std::abs(push));
    const Vec3 resisted = roll(k, n, push, overlap, advanced);
    return {push * n + pull, -arm_1 * n.cross(pull) + resisted, -arm_2 * n.cross(pull) - resisted};
  }

  void kick(const Load& load, double h) {
    bodies[0].v -= h * bodies[0].inverse_mass * load.force;
    bodies[1].v += h * bodies[1].inverse_mass * load.force;
    bodies[0].w += h * bodies[0].inverse_inertia * load.torque_1;
    bodies[1].w += h * bodies[1].inverse_inertia * load.torque_2;
  }

  /// Velocity Verlet; the frame after the scene's last step.
  Frame run() {
    const double h = scene.run.step;
    const auto last = static_cast<int>(std::ceil(scene.run.end / h - 1e-9));
    Load now = load(0.0);
    for (int n = 0; n < last; ++n) {
      kick(now, 0.5 * h);
      for (Body& body : bodies) body.x += h * body.v;
      now = load(h);
      kick(now, 0.5 * h);
    }
    Frame frame;
    for (std::size_t i = wall ? 1 : 0; i < 2; ++i) {
      frame.position.push_back(bodies[i].x);
      frame.velocity.push_back(bodies[i].v);
      frame.angular_velocity.push_back(bodies[i].w);
    }
    return frame;
  }
};

}  // namespace grainproof::test
