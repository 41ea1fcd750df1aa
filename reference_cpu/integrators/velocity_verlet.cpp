// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/integrators/scheme.hpp"

namespace grainproof::reference {
namespace {

double move(Bodies& bodies, const Flow&, double step, std::int64_t) {
  const double half_step = 0.5 * step;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies.body[i];
    body.velocity += bodies.acceleration[i] * half_step;
    body.position += body.velocity * step;
  }
  kick_spins(bodies, half_step);
  return half_step;
}

double settle(Bodies& bodies, double step) {
  const double half_step = 0.5 * step;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies.body[i].velocity += bodies.acceleration[i] * half_step;
  kick_spins(bodies, half_step);
  return half_step;
}

}  // namespace

Scheme velocity_verlet() {
  return {.move = move, .settle = settle};
}

}  // namespace grainproof::reference
