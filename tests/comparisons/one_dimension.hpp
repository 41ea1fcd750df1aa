// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {

struct Ball {
  double x, v;
};

/// Velocity Verlet with the half-step velocity in the dashpot, in one dimension: the second particle of
/// collision_with_fixed or collision_with_wall, whose surfaces touch at x = `touch`.
inline Ball bounced(const Scene& scene, double touch = 0.1, double restitution = restitution_value) {
  const Particle& moving = scene.particles.back();
  Ball ball{moving.position.x(), moving.velocity.x()};
  const double h = scene.run.step;
  const double m = mass();
  const double eta = restitution < 1.0 ? dashpot(restitution, m, stiffness) : 0.0;
  const auto acceleration = [&] {
    const double overlap = touch - ball.x;
    return overlap > 0.0 ? (stiffness * overlap - eta * ball.v) / m : 0.0;
  };
  double a = acceleration();
  const auto steps = static_cast<int>(std::ceil(scene.run.end / h - 1e-9));
  for (int n = 0; n < steps; ++n) {
    ball.v += 0.5 * h * a;
    ball.x += h * ball.v;
    a = acceleration();
    ball.v += 0.5 * h * a;
  }
  return ball;
}

}  // namespace grainproof::test
