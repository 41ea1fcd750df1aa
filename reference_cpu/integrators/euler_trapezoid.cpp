// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/integrators/scheme.hpp"

namespace grainproof::reference {
namespace {

// Andrews 3.1: explicit velocity, position from the mean of old and new velocity (E15).
double move(Bodies& bodies, const Flow&, double step, std::int64_t) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies.body[i];
    const Vec3 before = body.velocity;
    body.velocity += bodies.acceleration[i] * step;
    body.position += (before + body.velocity) * (0.5 * step);
  }
  kick_spins(bodies, step);
  return step;
}

}  // namespace

Scheme euler_trapezoid() {
  return {.move = move, .move_lag = 0.5};
}

}  // namespace grainproof::reference
