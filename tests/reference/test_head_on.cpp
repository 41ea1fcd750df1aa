// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double diameter = 0.1, stiffness = 1e5;

Scene head_on(double restitution, double second_diameter, double step) {
  Scene scene = empty_scene(linear(stiffness, Restitution{restitution}), step);
  add_particle(scene, diameter, {-0.06, 0.0, 0.0}, {1.0, 0.0, 0.0});
  add_particle(scene, second_diameter, {0.06, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  return scene;
}

/// Speed of separation over speed of approach.
double rebound(const Scene& scene, std::int64_t steps) {
  const Frame frame = frame_after(scene, steps);
  return (frame.velocity[1] - frame.velocity[0]).x() / 2.0;
}

// At 5000 steps a contact the first-order error of the onset is below 1e-4 (3e-3 at 64).
TEST(HeadOn, EqualPairLeavesWithRestitutionTimesSpeed) {
  for (const double restitution : {1.0, 0.8, 0.5, 0.1})
    EXPECT_NEAR(rebound(head_on(restitution, diameter, 1.4e-6), 30000), restitution, 1e-4);
}

TEST(HeadOn, UnequalPairLeavesWithRestitutionTimesSpeed) {
  for (const double restitution : {1.0, 0.8, 0.5})
    EXPECT_NEAR(rebound(head_on(restitution, 0.06, 0.8e-6), 60000), restitution, 1e-4);
}

TEST(HeadOn, FixedPartnerTakesTheMovingMass) {
  Scene scene = empty_scene(linear(stiffness, Restitution{0.8}), 2e-6);
  add_particle(scene, diameter, {0.0, 0.0, 0.0}).fixed = true;
  add_particle(scene, diameter, {0.11, 0.0, 0.0}, {-2.0, 0.0, 0.0});
  const Frame frame = frame_after(scene, 20000);
  EXPECT_NEAR(frame.velocity[1].x(), 1.6, 2e-4);
  EXPECT_EQ(frame.velocity[0], Vec3::Zero());
  EXPECT_EQ(frame.position[0], Vec3::Zero());
}

}  // namespace
}  // namespace grainproof::testing
