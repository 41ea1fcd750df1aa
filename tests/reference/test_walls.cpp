// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double force_tolerance = 1e-11;  // everything at rest, springs of order 10 N

/// One sphere of diameter 0.2 at rest, stiffness 1000.
Scene sphere_at(const Vec3& position) {
  Scene scene = empty_scene(linear(1000.0, Damping{0.0}), 1e-4);
  add_particle(scene, 0.2, position);
  return scene;
}

/// The rectangle [0, 1] × [0, 2] at z = 0.5.
Scene above_rectangle(const Vec3& position) {
  Scene scene = sphere_at(position);
  scene.walls.push_back({"plate", 0, Rectangle{{0.0, 0.0, 0.5}, {1.0, 2.0, 0.5}}});
  return scene;
}

void expect_force(const Scene& scene, const Vec3& expected) {
  EXPECT_LE((force_on(scene, 0) - expected).norm(), force_tolerance);
}

TEST(Walls, PlanePushesAlongItsNormalByRadiusLessDistance) {
  Scene scene = sphere_at({0.3, 0.0, 0.4});
  const Vec3 normal(0.6, 0.0, 0.8);
  add_plane(scene, normal * 0.41, normal);
  expect_force(scene, 1000.0 * 0.01 * normal);
}

TEST(Walls, PlaneOutOfReachDoesNothing) {
  Scene scene = sphere_at({0.0, 0.0, 0.1 + 1e-9});
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  EXPECT_EQ(force_on(scene, 0), Vec3::Zero());
}

TEST(Walls, RectangleIsSolidFromBothSides) {
  expect_force(above_rectangle({0.5, 1.0, 0.59}), {0.0, 0.0, 10.0});
  expect_force(above_rectangle({0.5, 1.0, 0.41}), {0.0, 0.0, -10.0});
}

TEST(Walls, RectangleEdgePushesAwayFromItself) {
  expect_force(above_rectangle({1.0 + 0.06, 1.0, 0.5 + 0.06}),
               1000.0 * (0.1 - 0.06 * std::sqrt(2.0)) * Vec3(1.0, 0.0, 1.0).normalized());
}

TEST(Walls, RectangleCornerPushesAwayFromItself) {
  expect_force(above_rectangle({-0.05, 2.05, 0.45}),
               1000.0 * (0.1 - 0.05 * std::sqrt(3.0)) * Vec3(-1.0, 1.0, -1.0).normalized());
}

TEST(Walls, BesideTheRectangleThereIsNothing) {
  EXPECT_EQ(force_on(above_rectangle({1.09, 1.0, 0.55}), 0), Vec3::Zero());
}

TEST(Walls, RectangleReachesAcrossAPeriodicFace) {
  Scene scene = above_rectangle({-1.0 + 1e-3, 1.0, 0.5});
  scene.domain = {.lower = {-1.0, -5.0, -5.0}, .upper = {1.05, 5.0, 5.0}};
  scene.domain.boundary[0] = Boundary::periodic;
  expect_force(scene, {1000.0 * (0.1 - 0.051), 0.0, 0.0});
}

TEST(Walls, RectangleOverAWholePeriodHasNoEdges) {
  Scene scene = above_rectangle({0.999, 1.0, 0.59});
  scene.domain = {.lower = {0.0, -5.0, -5.0}, .upper = {1.0, 5.0, 5.0}};
  scene.domain.boundary[0] = Boundary::periodic;
  expect_force(scene, {0.0, 0.0, 10.0});
}

// A wall's normal, like a pair's, points to the particle: friction opposes its slide.
TEST(Walls, FrictionOpposesTheSlideOnAWall) {
  Scene scene = above_rectangle({0.5, 1.0, 0.59});
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.friction = DynamicFriction{0.5};
  scene.contacts.set(0, 0, laws);
  scene.particles[0].velocity = {0.0, -0.2, 0.0};
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, 5.0, 10.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace grainproof::testing
