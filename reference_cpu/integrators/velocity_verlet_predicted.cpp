// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/integrators/scheme.hpp"

namespace grainproof::reference {
namespace {

// What forces see as velocity is the boundary's, as the accelerations before it foretell.
double move(Bodies& bodies, const Flow&, double step, std::int64_t) {
  const double half_step = 0.5 * step;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies.body[i];
    const Vec3 kick = bodies.acceleration[i] * half_step;
    const Vec3 half = body.velocity + kick;
    bodies.half_velocity[i] = half;
    body.position += half * step;
    body.velocity = half + kick;
  }
  for (std::size_t i = 0; i < bodies.spin.size(); ++i) {
    const Vec3 kick = bodies.angular_acceleration[i] * half_step;
    const Vec3 half = bodies.spin[i].angular_velocity + kick;
    bodies.half_spin[i] = half;
    bodies.spin[i].angular_velocity = half + kick;
  }
  bodies.predicted = true;
  return half_step;
}

double settle(Bodies& bodies, double step) {
  const double half_step = 0.5 * step;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies.body[i].velocity = bodies.half_velocity[i] + bodies.acceleration[i] * half_step;
  for (std::size_t i = 0; i < bodies.spin.size(); ++i)
    bodies.spin[i].angular_velocity = bodies.half_spin[i] + bodies.angular_acceleration[i] * half_step;
  bodies.predicted = false;
  return half_step;
}

}  // namespace

Scheme velocity_verlet_predicted() {
  return {.move = move, .settle = settle, .move_lag = 0.5};
}

}  // namespace grainproof::reference
