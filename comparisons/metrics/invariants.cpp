// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/invariants.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "comparisons/metrics/mass.hpp"

namespace grainproof {
namespace {

constexpr const char* no_ledger = "the engine gave no ledger";

/// Σ m v, and Σ m |v| as its scale, over the moving particles.
struct Momentum {
  Vec3 sum = Vec3::Zero();
  double scale = 0.0;
};

Momentum momentum(const Scene& scene, const Frame& frame) {
  Momentum total;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    if (scene.particles[i].fixed) continue;
    const Vec3 own = mass_of(scene, scene.particles[i]) * frame.velocity[i];
    total.sum += own;
    total.scale += own.norm();
  }
  return total;
}

/// Σ (m x × v + I ω) about the origin, and the sum of the sizes as its scale.
Momentum angular_momentum(const Scene& scene, const Frame& frame) {
  Momentum total;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& body = scene.particles[i];
    if (body.fixed) continue;
    Vec3 own = mass_of(scene, body) * frame.position[i].cross(frame.velocity[i]);
    total.scale += mass_of(scene, body) * frame.position[i].norm() * frame.velocity[i].norm();
    if (!frame.angular_velocity.empty()) {
      own += inertia_of(scene, body) * frame.angular_velocity[i];
      total.scale += inertia_of(scene, body) * frame.angular_velocity[i].norm();
    }
    total.sum += own;
  }
  return total;
}

/// Empty where walls that stand still, whose moments the ledger keeps, are all that acts from outside.
std::string turned_from_outside(const Scene& scene) {
  const auto* gravity = std::get_if<ConstantGravity>(&scene.gravity);
  if (!gravity || !gravity->acceleration.isZero()) return "gravity gives angular momentum too";
  if (!std::holds_alternative<NoFlow>(scene.flow)) return "the fluid gives angular momentum too";
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.periodic(axis)) return "there is none in a periodic domain";
  for (const Particle& particle : scene.particles)
    if (particle.fixed) return "fixed particles give angular momentum too";
  for (const Wall& wall : scene.walls)
    if (!std::holds_alternative<Still>(wall.motion)) return "a wall's moment is about a point that moves";
  return {};
}

Vec3 reference_point(const Wall& wall) {
  return std::visit(Overloaded{[](const Rectangle& flat) { return flat.lower; },
                               [](const auto& shape) { return shape.point; }},
                    wall.shape);
}

double largest_entry(const Ledger& ledger) {
  return std::max({std::abs(ledger.kinetic), std::abs(ledger.elastic), std::abs(ledger.cohesive),
                   std::abs(ledger.gravity_work), std::abs(ledger.drag_work), std::abs(ledger.wall_work),
                   std::abs(ledger.dissipated_normal), std::abs(ledger.dissipated_tangential),
                   std::abs(ledger.dissipated_rolling)});
}

bool inside(const Domain& domain, const Vec3& x) {
  for (int axis = 0; axis < 3; ++axis)
    if (!domain.periodic(axis) && !(x[axis] >= domain.lower[axis] && x[axis] <= domain.upper[axis]))
      return false;
  return x.allFinite();
}

Measured relative(double error, double scale) {
  if (scale == 0.0 && error == 0.0) return Measured::of(0.0);
  return Measured::of(error / scale);
}

}  // namespace

Measured momentum_error(const Scene& scene, const Observations& seen, const Observations&) {
  if (!seen.initial_ledger || !seen.final_ledger) return Measured::none(no_ledger);
  const Vec3 support = seen.final_ledger->support_impulse - seen.initial_ledger->support_impulse;
  const Vec3 field = seen.final_ledger->field_impulse - seen.initial_ledger->field_impulse;
  const Vec3 change = momentum(scene, seen.frames.back()).sum - momentum(scene, seen.frames.front()).sum;
  double scale = 0.0;
  for (const Frame& frame : seen.frames) scale = std::max(scale, momentum(scene, frame).scale);
  return relative((change - support - field).norm(), scale + support.norm() + field.norm());
}

Measured angular_momentum_error(const Scene& scene, const Observations& seen, const Observations&) {
  if (const std::string why = turned_from_outside(scene); !why.empty()) return Measured::none(why);
  if (!seen.final_ledger || seen.final_ledger->wall_impulses.size() != scene.walls.size())
    return Measured::none(no_ledger);
  Vec3 given = Vec3::Zero();
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
    given += seen.final_ledger->wall_angular_impulses[w] +
             reference_point(scene.walls[w]).cross(seen.final_ledger->wall_impulses[w]);
  const Momentum before = angular_momentum(scene, seen.frames.front());
  const Momentum after = angular_momentum(scene, seen.frames.back());
  return relative((after.sum - before.sum - given).norm(),
                  std::max(before.scale, after.scale) + given.norm());
}

Measured energy_error(const Scene&, const Observations& seen, const Observations&) {
  if (!seen.initial_ledger || !seen.final_ledger) return Measured::none(no_ledger);
  const double scale = std::max(largest_entry(*seen.initial_ledger), largest_entry(*seen.final_ledger));
  return relative(seen.final_ledger->balance() - seen.initial_ledger->balance(), scale);
}

Measured lost_particles(const Scene& scene, const Observations& seen, const Observations&) {
  std::size_t most = 0;
  for (const Frame& frame : seen.frames) {
    const auto kept = std::count_if(frame.position.begin(), frame.position.end(),
                                    [&](const Vec3& x) { return inside(scene.domain, x); });
    most = std::max(most, scene.particles.size() - static_cast<std::size_t>(kept));
  }
  return relative(static_cast<double>(most), static_cast<double>(scene.particles.size()));
}

}  // namespace grainproof
