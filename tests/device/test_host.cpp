// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What the host works out before a device is asked.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/errors.hpp"
#include "opencl/coordinates.hpp"
#include "opencl/near_walls.hpp"
#include "opencl/pair_laws.hpp"
#include "opencl/scene_image.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

TEST(PairLaws, DampingOfRestitutionIsAndrews217) {
  const double eta = damping_of({1e5, Restitution{0.8}, false}).at(1.047);
  const double log_e = std::log(0.8);
  const double expected =
      -2 * log_e * std::sqrt(1.047 * 1e5 / (std::pow(std::numbers::pi, 2) + log_e * log_e));
  EXPECT_DOUBLE_EQ(eta, expected);
  EXPECT_DOUBLE_EQ(damping_of({1e5, Restitution{0.0}, false}).at(1.047), 2 * std::sqrt(1.047 * 1e5));
  EXPECT_EQ(damping_of({1e5, Restitution{1.0}, false}).at(1.047), 0.0);
  EXPECT_EQ(damping_of({1e5, Damping{33.0}, false}).at(1.047), 33.0);
}

TEST(PairLaws, WithoutTensionTheRatioOfTheSimpleLawReboundsAt080810) {
  const double log_e = std::log(0.8);
  const double simple = -log_e / std::sqrt(std::pow(std::numbers::pi, 2) + log_e * log_e);
  EXPECT_NEAR(damping_ratio_without_tension(0.80810), simple,
              2e-5 * simple);  // five figures of Schwager and Pöschel
}

TEST(PairLaws, WithoutTensionCriticalDampingReboundsAtExpMinusTwo) {
  EXPECT_NEAR(damping_ratio_without_tension(std::exp(-2.0)), 1.0, 1e-7);
  EXPECT_EQ(damping_ratio_without_tension(1.0), 0.0);
  EXPECT_GT(damping_ratio_without_tension(0.01), 4.0);
}

TEST(PairLaws, WithoutTensionNothingReboundsAtZero) {
  EXPECT_THROW(damping_ratio_without_tension(0.0), InputRefused);
}

TEST(Coordinates, SingleReturnsPositionsToAFractionOfAQuantum) {
  const Domain domain{Vec3(1, -2, 30), Vec3(3, -1.5, 31), {}};
  const Coordinates<Single> coordinates(domain);
  for (const Vec3& x : {Vec3(1, -2, 30), Vec3(3, -1.5, 31), Vec3(2.123456789123, -1.7, 30.3)})
    EXPECT_LE((coordinates.metres(coordinates.position(x)) - x).norm(), 2 * 0x1p-30 * 0x1p-25 + 31 * 0x1p-52);
}

TEST(Coordinates, DoubleKeepsNumbersOfASceneAroundZero) {
  const Domain around{Vec3(-0.5, 0.0, -3), Vec3(0.5, 1, 0), {}};
  EXPECT_EQ(Coordinates<Double>(around).position({0.05, 0.1, -0.3}).at.s[0], 0.05);
  const Domain beyond{Vec3(1, 1, 1), Vec3(2, 2, 2), {}};
  EXPECT_EQ(Coordinates<Double>(beyond).position({1.25, 1, 1}).at.s[0], 0.25);
}

TEST(NearWalls, ClipsARectangleThatReachesFarBeyondTheDomain) {
  Scene scene = head_on_scene(0.8, 64);
  scene.walls = {{"floor", 0, Rectangle{{-1e4, -0.5, 0}, {1e4, 0.5, 0}}}};
  const NearWalls near = near_walls(scene);
  ASSERT_EQ(near.rectangles.size(), 1u);
  EXPECT_EQ(near.rectangles[0].shape.lower, Vec3(-1.05, -0.5, 0));
  EXPECT_EQ(near.rectangles[0].shape.upper, Vec3(1.05, 0.5, 0));
}

TEST(ZoneGrid, IsAtLeastAsWideAsTwoReachesAndTheSkin) {
  Scene scene = head_on_scene(0.8, 64);
  for (int i = 2; i < 2000; ++i) scene.particles.push_back(sphere(i, Vec3::Zero(), Vec3::Zero()));
  const ZoneGrid grid = choose_zones(scene, 0.01);
  EXPECT_EQ(grid.zones,
            (std::array{14, 14, 14}));  // 2 m in zones of 0.11 m would be 18: 5832 for 2000 particles
  EXPECT_GE(2.0 / grid.zones[0], 0.11);
}

}  // namespace
}  // namespace grainproof::opencl::testing
