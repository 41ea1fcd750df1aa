// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// One sphere of diameter 0.2 at rest, stiffness 1000, at a slanted cylinder of radius 1 through (0, 0, 0.5).
Scene at_cylinder(Cylinder::Side side, const Vec3& position) {
  Scene scene = empty_scene(linear(1000.0, Damping{0.0}), 1e-4);
  add_particle(scene, 0.2, position);
  scene.walls.push_back({"pipe", 0, Cylinder{{0.0, 0.0, 0.5}, {0.6, 0.0, 0.8}, 1.0, side}});
  return scene;
}

const Vec3 along(0.6, 0.0, 0.8), across(0.8, 0.0, -0.6);

Vec3 at_distance(double from_axis) {
  return Vec3(0.0, 0.0, 0.5) + 0.7 * along + from_axis * across;
}

TEST(Cylinders, HollowOnePushesTowardsItsAxis) {
  const Scene scene = at_cylinder(Cylinder::Side::inside, at_distance(0.91));
  EXPECT_LE((force_on(scene, 0) + 10.0 * across).norm(), 1e-10);
  EXPECT_EQ(force_on(at_cylinder(Cylinder::Side::inside, at_distance(0.9 - 1e-9)), 0), Vec3::Zero());
}

TEST(Cylinders, SolidOnePushesAwayFromItsAxis) {
  const Scene scene = at_cylinder(Cylinder::Side::outside, at_distance(1.09));
  EXPECT_LE((force_on(scene, 0) - 10.0 * across).norm(), 1e-10);
  EXPECT_EQ(force_on(at_cylinder(Cylinder::Side::outside, at_distance(1.1 + 1e-9)), 0), Vec3::Zero());
}

TEST(Cylinders, OnItsAxisAParticleFeelsNothing) {
  EXPECT_EQ(force_on(at_cylinder(Cylinder::Side::inside, at_distance(0.0)), 0), Vec3::Zero());
}

// ω² = g/(R − r) for a sphere that slides in a gutter: a quarter of the period of a small swing from 1e-3,
// which lengthens by 1/16 of the angle's square. Its resting overlap of 1e-5 m changes R − r by 1e-5.
TEST(Cylinders, SlidingInAGutterIsAPendulum) {
  Scene scene = empty_scene(linear(2e6, Damping{0.0}), 2e-5);
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  scene.walls.push_back({"gutter", 0, Cylinder{Vec3::Zero(), Vec3::UnitX(), 1.0, Cylinder::Side::inside}});
  const double deep = sphere_mass(0.2) * 9.81 / 2e6, arm = 0.9 + deep;
  add_particle(scene, 0.2, {0.0, arm * std::sin(1e-3), -arm * std::cos(1e-3)});
  const auto run = start(scene);
  while (run->frame().position[0].y() > 0.0) run->advance(1);
  const double quarter = 0.5 * std::numbers::pi * std::sqrt(arm / 9.81);
  EXPECT_NEAR(run->frame().time, quarter, 2e-5 + 1e-6 * quarter);
}

}  // namespace
}  // namespace grainproof::testing
