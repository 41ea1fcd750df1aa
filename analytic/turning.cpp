// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/turning.hpp"

#include <Eigen/Geometry>
#include <limits>

#include "analytic/hertz_encounter.hpp"

namespace grainproof::analytic {

Vec3 slip_of(const Scene& scene, const Encounter& e) {
  const Particle& sphere = scene.particles[e.second];
  return e.slip - 0.5 * sphere.diameter * sphere.angular_velocity.cross(e.normal);
}

Frame frame_of_sphere(const Scene& scene, const Encounter& e, const Motion& gap, const Vec3& path,
                      const Vec3& lost, double time) {
  Frame frame = frame_of(scene, e, gap, {path, e.slip - lost}, time);
  const double radius = 0.5 * scene.particles[e.second].diameter;
  frame.angular_velocity[e.second] += 2.5 / radius * e.normal.cross(lost);
  return frame;
}

Rub rub_of(const Scene& scene, const Encounter& e, double overlap) {
  if (const auto* dynamic = std::get_if<DynamicFriction>(&e.laws.friction))
    return {dynamic->coefficient, std::numeric_limits<double>::infinity()};
  const auto& history = std::get<HistoryFriction>(e.laws.friction);
  const bool hertz = std::holds_alternative<HertzNormal>(e.laws.normal);
  return {history.coefficient,
          hertz ? hertz_pair_of(scene, e).tangential_stiffness(overlap) : history.stiffness};
}

std::string why_not_turning(const Scene& scene, const Encounter& e) {
  if (!scene.rotation) return "nothing turns in this scene";
  if (e.cohesion_stiffness() > 0.0) return "cohesion acts";
  if (std::holds_alternative<DynamicFriction>(e.laws.friction)) return "";
  const auto* history = std::get_if<HistoryFriction>(&e.laws.friction);
  if (!history) return "the friction is neither dynamic nor a spring";
  return history->arm == TorqueArm::radius ? "" : "the torque arm changes with the overlap";
}

}  // namespace grainproof::analytic
