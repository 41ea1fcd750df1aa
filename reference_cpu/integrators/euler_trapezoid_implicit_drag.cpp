// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/integrators/scheme.hpp"
#include "reference_cpu/laws/flow.hpp"

namespace grainproof::reference {
namespace {

/// Velocity at the end of the step under drag that acts with that very velocity, fluid as it is now.
/// (v + r u)/(1 + r), written so that the round-off of 1 + r does not slow down everything that moves.
Vec3 implicit_velocity(const Vec3& without_drag, const Vec3& fluid, double steps_per_response) {
  return without_drag + (fluid - without_drag) * (steps_per_response / (1.0 + steps_per_response));
}

double move(Bodies& bodies, const Flow& flow, double step, std::int64_t) {
  const bool drag = !bodies.drag_rate.empty();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies.body[i];
    if (body.fixed()) continue;
    const Vec3 before = body.velocity;
    body.velocity += bodies.acceleration[i] * step;
    if (drag)
      body.velocity =
          implicit_velocity(body.velocity, fluid_velocity(flow, body.position), step * bodies.drag_rate[i]);
    body.position += (before + body.velocity) * (0.5 * step);
  }
  kick_spins(bodies, step);
  return step;
}

}  // namespace

Scheme euler_trapezoid_implicit_drag() {
  return {.move = move, .applies_drag = true, .move_lag = 0.5};
}

}  // namespace grainproof::reference
