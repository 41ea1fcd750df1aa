// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// A unit cube from −0.25 to 0.75 with the given periodic axes.
Scene periodic_cube(std::initializer_list<int> axes) {
  Scene scene = empty_scene(linear(1000.0, Damping{0.0}), 1e-4);
  scene.domain = {.lower = Vec3::Constant(-0.25), .upper = Vec3::Constant(0.75)};
  for (const int axis : axes) scene.domain.boundary[axis] = Boundary::periodic;
  return scene;
}

/// Two spheres of diameter 0.2 at rest, the second `apart` beyond the first through the faces.
void expect_force_across(Scene scene, const Vec3& first, const Vec3& apart) {
  Vec3 second = first + apart;
  for (int axis = 0; axis < 3; ++axis)
    if (second[axis] > 0.75) second[axis] -= 1.0;
  add_particle(scene, 0.2, first);
  add_particle(scene, 0.2, second);
  const Vec3 expected = 1000.0 * (0.2 - apart.norm()) * apart.normalized();
  EXPECT_LE((force_on(scene, 1) - expected).norm(), 1e-11);
  EXPECT_LE((force_on(scene, 0) + expected).norm(), 1e-11);
}

TEST(Periodic, PairTouchesAcrossAFace) {
  expect_force_across(periodic_cube({0}), {0.7, 0.1, 0.1}, {0.18, 0.02, -0.03});
}

TEST(Periodic, PairTouchesAcrossAnEdge) {
  expect_force_across(periodic_cube({0, 2}), {0.7, 0.1, 0.69}, {0.12, 0.02, 0.13});
}

TEST(Periodic, PairTouchesAcrossACorner) {
  expect_force_across(periodic_cube({0, 1, 2}), {0.7, 0.72, 0.69}, {0.1, 0.1, 0.12});
}

TEST(Periodic, FaceThatIsNotPeriodicSeparates) {
  Scene scene = periodic_cube({1});
  add_particle(scene, 0.2, {0.7, 0.1, 0.1});
  add_particle(scene, 0.2, {-0.2, 0.1, 0.1});
  EXPECT_EQ(force_on(scene, 0), Vec3::Zero());
}

// Ten crossings; each wrap may cost a last digit of the position.
TEST(Periodic, ParticleComesBackInsideOnTheOtherSide) {
  Scene scene = periodic_cube({0});
  scene.run.step = 0.01;
  add_particle(scene, 0.1, {0.5, 0.0, 0.0}, {1.0, 0.0, 0.0});
  const auto run = start(scene);
  for (int n = 1; n <= 1000; ++n) {
    run->advance(1);
    const double x = run->frame().position[0].x();
    ASSERT_GE(x, -0.25);
    ASSERT_LT(x, 0.75);
  }
  EXPECT_NEAR(run->frame().position[0].x(), 0.5, 1e-12);
}

TEST(Periodic, BackwardsToo) {
  Scene scene = periodic_cube({0});
  scene.run.step = 0.01;
  add_particle(scene, 0.1, {-0.249, 0.0, 0.0}, {-0.5, 0.0, 0.0});
  EXPECT_NEAR(frame_after(scene, 1).position[0].x(), 0.746, 1e-15);
}

TEST(Periodic, ParticleGivenOnTheUpperFaceIsReportedOnTheLower) {
  Scene scene = periodic_cube({0});
  add_particle(scene, 0.1, {0.75, 0.0, 0.0});
  EXPECT_EQ(start(scene)->frame().position[0].x(), -0.25);
}

// −0.25 less 2⁻⁵⁵ plus the period 1 rounds to the upper face, which is outside.
TEST(Periodic, LastDigitBeyondTheLowerFaceStaysInside) {
  Scene scene = periodic_cube({0});
  add_particle(scene, 0.1, {std::nextafter(-0.25, -1.0), 0.0, 0.0});
  const double x = start(scene)->frame().position[0].x();
  EXPECT_GE(x, -0.25);
  EXPECT_LT(x, 0.75);
}

}  // namespace
}  // namespace grainproof::testing
