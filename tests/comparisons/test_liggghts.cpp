// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/liggghts/engine.hpp"
#include "comparisons/metrics/collision.hpp"
#include "comparisons/metrics/resting.hpp"
#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {
namespace {

LiggghtsEngine& liggghts() {
  static LiggghtsEngine engine;
  return engine;
}

/// Velocity Verlet with the half-step velocity in the dashpot, in one dimension, written out here.
struct Ball {
  double x, v;
};

Ball bounced(const Scene& scene, double eta) {
  Ball ball{scene.particles[1].position.x(), scene.particles[1].velocity.x()};
  const double h = scene.run.step;
  const double m = mass();
  const auto acceleration = [&] {
    const double overlap = 0.1 - ball.x;
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

TEST(LiggghtsHeadOn, ReboundIsThatOfPlainVelocityVerlet) {
  for (const double steps : {8.3, 16.0, 64.7, 256.0}) {
    const Scene scene = collision_with_fixed(steps, 0.4);
    const Observations seen = liggghts().observe(scene, {});
    ASSERT_EQ(seen.frames.size(), 2u);
    const Ball expected = bounced(scene, dashpot(restitution_value, mass(), stiffness));
    EXPECT_NEAR(seen.frames.back().velocity[1].x() / expected.v, 1.0, 1e-9);
    EXPECT_NEAR(seen.frames.back().position[1].x(), expected.x, 1e-12);
    RecordProperty(
        "rebound_" + std::to_string(static_cast<int>(steps)),
        std::to_string(std::abs(seen.frames.back().velocity[1].x() / expected.v - 1.0) * 1e15) + "e-15");
    EXPECT_EQ(seen.frames.back().position[0], Vec3(Vec3::Zero()));
  }
}

TEST(LiggghtsSettling, OverlapBecomesWeightOverStiffness) {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{restitution_value}}});
  scene.walls = {{"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}}};
  scene.domain.lower.z() = 0.0;
  scene.gravity = ConstantGravity{Vec3(0.0, 0.0, -9.81)};
  scene.particles = {particle(1, Vec3(0.0, 0.0, 0.05), Vec3::Zero())};
  run_for(scene, 3.0, 1.6e-4);
  const Observations seen = liggghts().observe(scene, {});
  const Measured overlap = resting_overlap(scene, seen);
  ASSERT_TRUE(overlap.exists()) << overlap.because;
  // 0.05 m is held to 3.5e-18 m, 3.4e-14 of the overlap; a few such roundings a step
  EXPECT_NEAR(overlap.value / (mass() * 9.81 / stiffness), 1.0, 1e-12);
}

}  // namespace
}  // namespace grainproof::test
