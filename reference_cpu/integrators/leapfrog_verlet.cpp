// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/integrators/scheme.hpp"

namespace grainproof::reference {
namespace {

// Sweetman 2.19. The first kick brings the velocity from the start to the middle of the first step.
double move(Bodies& bodies, const Flow&, double step, std::int64_t steps_done) {
  const double kick = steps_done == 0 ? 0.5 * step : step;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies.body[i];
    body.velocity += bodies.acceleration[i] * kick;
    body.position += body.velocity * step;
  }
  kick_spins(bodies, kick);
  return kick;
}

}  // namespace

Scheme leapfrog_verlet() {
  return {.move = move, .velocity_lag = 0.5};
}

}  // namespace grainproof::reference
