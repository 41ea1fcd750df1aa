// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/integrators/scheme.hpp"

namespace grainproof::reference {
namespace {

/// From what is held in the middle of the step to its end, under the accelerations as they are.
void go_on_from_the_middle(Bodies& bodies, double half_step) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies.body[i].velocity = bodies.half_velocity[i] + bodies.acceleration[i] * half_step;
  for (std::size_t i = 0; i < bodies.spin.size(); ++i)
    bodies.spin[i].angular_velocity = bodies.half_spin[i] + bodies.angular_acceleration[i] * half_step;
}

// Springs are stretched with the velocity in the middle of the step, which is what moves the bodies.
double move(Bodies& bodies, const Flow&, double step, std::int64_t) {
  kick(bodies, 0.5 * step);
  drift(bodies, step);
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies.half_velocity[i] = bodies.body[i].velocity;
  for (std::size_t i = 0; i < bodies.spin.size(); ++i) bodies.half_spin[i] = bodies.spin[i].angular_velocity;
  return 0.5 * step;
}

// The velocity that the step would end with if there were no dashpots.
void foresee(Bodies& bodies, double step) {
  go_on_from_the_middle(bodies, 0.5 * step);
  bodies.predicted = true;
}

double settle(Bodies& bodies, double step) {
  go_on_from_the_middle(bodies, 0.5 * step);
  bodies.predicted = false;
  return 0.5 * step;
}

}  // namespace

Scheme velocity_verlet_implicit() {
  return {.move = move, .settle = settle, .foresee = foresee};
}

}  // namespace grainproof::reference
