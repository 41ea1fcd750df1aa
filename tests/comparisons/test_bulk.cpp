// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "comparisons/metrics/bed.hpp"
#include "comparisons/metrics/bulk.hpp"
#include "comparisons/metrics/walls.hpp"
#include "tests/comparisons/scenes.hpp"

/// Statistics of many bodies and the geometry of walls, on bodies few enough to count by hand.
namespace grainproof::test {
namespace {

Observations at(const Scene& scene) {
  Observations seen;
  Frame frame;
  for (const Particle& body : scene.particles) {
    frame.position.push_back(body.position);
    frame.velocity.push_back(body.velocity);
  }
  seen.frames = {frame};
  return seen;
}

/// Spheres of 0.1 m over each other at multiples of `spacing`, in a box 0.1 m wide.
Scene column(int count, double spacing) {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{0.8}}});
  scene.domain = {Vec3(-0.05, -0.05, 0.0), Vec3(0.05, 0.05, 2.0)};
  scene.gravity = ConstantGravity{Vec3(0.0, 0.0, -9.81)};
  for (int i = 0; i < count; ++i)
    scene.particles.push_back(particle(i + 1, Vec3(0.0, 0.0, 0.05 + spacing * i), Vec3::Zero()));
  return scene;
}

TEST(Packing, OfAColumnThatTouchesIsPiOverSixInEveryThird) {
  const Scene scene = column(9, 0.1);
  for (int third = 0; third < 3; ++third)
    EXPECT_NEAR(packing_of(scene, at(scene), third).value, std::numbers::pi / 6.0, 1e-14);
}

TEST(Packing, CountsTheCutsOfASphereOnBothSides) {
  const Scene scene = column(1, 0.1);  // height 0.1: thirds hold 7/27, 13/27, 7/27 of the sphere
  EXPECT_NEAR(packing_of(scene, at(scene), 0).value, 7.0 / 27.0 * std::numbers::pi / 2.0, 1e-14);
  EXPECT_NEAR(packing_of(scene, at(scene), 1).value, 13.0 / 27.0 * std::numbers::pi / 2.0, 1e-14);
}

TEST(ContactForce, IsStiffnessTimesOverlapOfPairsAndWalls) {
  Scene scene = column(3, 0.099);
  scene.walls = {{"floor", 0, Plane{Vec3(0.0, 0.0, 0.003), Vec3::UnitZ()}}};
  EXPECT_NEAR(contact_force(scene, at(scene)).value, stiffness * (0.001 + 0.001 + 0.003) / 3.0, 1e-9);
  EXPECT_NEAR(contact_force_spread(scene, at(scene)).value, std::sqrt(8.0 / 9.0) / (5.0 / 3.0), 1e-12);
  scene.contacts.set(0, 0, {HertzNormal{Restitution{0.8}}});
  scene.materials[0].elasticity = Elasticity{2e7, 0.3};
  const auto hertz = [](double radius, double overlap) {
    return 4.0 / 3.0 * 2e7 / (2.0 * 0.91) * std::sqrt(radius * overlap) * overlap;
  };
  EXPECT_NEAR(
      contact_force(scene, at(scene)).value / ((2.0 * hertz(0.025, 0.001) + hertz(0.05, 0.003)) / 3.0), 1.0,
      1e-12);
}

// Of four frames the last two: 3 contacts of (1 + 1 + 3) mm, and none once the floor and the spheres are
// apart.
TEST(ContactForce, IsTheMeanOverTheContactsOfTheSecondHalf) {
  Scene scene = column(3, 0.099);
  scene.walls = {{"floor", 0, Plane{Vec3(0.0, 0.0, 0.003), Vec3::UnitZ()}}};
  const Frame pressed = at(scene).frames[0];
  Frame apart = pressed, deep = pressed;
  for (int i = 0; i < 3; ++i) {
    apart.position[i].z() = 0.2 * (i + 1);
    deep.position[i].z() *= 0.5;
  }
  Observations seen = at(scene);
  seen.frames = {deep, deep, pressed, apart};
  EXPECT_NEAR(contact_force(scene, seen).value, stiffness * 0.005 / 3.0, 1e-9);
  EXPECT_NEAR(mean_contact_number(scene, seen).value, 0.5 * 2.0 * 2.0 / 3.0, 1e-15);
  EXPECT_EQ(contact_number(scene, seen).value, 0.0);
}

TEST(DischargeRate, IsTheMassThatGoesBelowTheRectanglePerSecond) {
  Scene scene = column(10, 0.1);
  scene.walls = {{"hole", 0, Rectangle{Vec3(-0.5, -0.5, 0.5), Vec3(-0.2, 0.5, 0.5)}}};
  Observations seen;
  for (int k = 0; k < 10; ++k) {  // one more sphere below every 0.25 s
    Observations now = at(scene);
    for (int i = 0; i < 10; ++i) now.frames[0].position[i].z() = i < k ? 0.1 : 1.0;
    now.frames[0].time = 0.25 * k;
    seen.frames.push_back(now.frames[0]);
  }
  EXPECT_NEAR(discharge_rate(scene, seen).value / (4.0 * mass()), 1.0, 1e-12);
  seen.frames.resize(3);
  EXPECT_FALSE(discharge_rate(scene, seen).exists());
}

TEST(SlopeAngle, IsThatOfTheCentreOfMassAgainstGravityInTheSenseOfTheAxis) {
  Scene scene = column(1, 0.1);
  scene.gravity = ConstantGravity{Vec3(0.0, -9.81, 0.0)};
  scene.walls = {{"drum", 0, Cylinder{Vec3(0.1, 0.0, 0.0), Vec3::UnitZ(), 0.5, Cylinder::Side::inside}}};
  scene.particles[0].position = Vec3(0.1 + 0.3 * std::sin(0.4), -0.3 * std::cos(0.4), 0.7);
  EXPECT_NEAR(slope_angle(scene, at(scene)).value, 0.4, 1e-14);  // a drum that turns about +z lifts it so
}

TEST(Walls, CylinderIsNearestAcrossItsAxisOnEitherSide) {
  const Cylinder round{Vec3(1.0, 0.0, 0.0), Vec3::UnitZ(), 0.5, Cylinder::Side::inside};
  const Facing within = facing({"drum", 0, round, Rotating{3.0}}, Vec3(1.3, 0.0, 7.0), 0.0);
  EXPECT_NEAR(within.distance, 0.2, 1e-15);
  EXPECT_EQ(within.normal, Vec3(-1.0, 0.0, 0.0));
  EXPECT_NEAR((within.surface_velocity - Vec3(0.0, 1.5, 0.0)).norm(), 0.0, 1e-15);
  Cylinder pole = round;
  pole.side = Cylinder::Side::outside;
  const Facing beyond = facing({"pole", 0, pole}, Vec3(1.0, 2.0, 7.0), 0.0);
  EXPECT_NEAR(beyond.distance, 1.5, 1e-15);
  EXPECT_EQ(beyond.normal, Vec3(0.0, 1.0, 0.0));
}

TEST(Walls, MoveAsTheirMotionSays) {
  const Plane floor{Vec3::Zero(), Vec3::UnitZ()};
  const Wall shaken{"floor", 0, floor, Vibrating{Vec3(0.0, 0.0, 0.01), 5.0, 0.0}};
  const double quarter = 0.05;  // a quarter of a period: fully out, and at rest
  EXPECT_NEAR(facing(shaken, Vec3(0.0, 0.0, 0.1), quarter).distance, 0.09, 1e-15);
  EXPECT_NEAR(facing(shaken, Vec3::Zero(), quarter).surface_velocity.norm(), 0.0, 1e-15);
  EXPECT_NEAR(facing(shaken, Vec3::Zero(), 0.0).surface_velocity.z(), 0.01 * 10.0 * std::numbers::pi, 1e-15);
  const Wall rising{"floor", 0, floor, Translating{Vec3(0.0, 0.0, 2.0)}};
  EXPECT_NEAR(facing(rising, Vec3::Zero(), 0.5).distance, -1.0, 1e-15);
}

TEST(Walls, StraightFlightMeetsACylinderWhereItIs) {
  const Cylinder round{Vec3::Zero(), Vec3::UnitZ(), 0.5, Cylinder::Side::inside};
  const Vec3 start(0.0, 0.3, 0.0);
  const double time = time_to_reach({"drum", 0, round}, start, 0.0, Vec3(2.0, 0.0, 1.0), 0.1);
  EXPECT_NEAR(time, std::sqrt(0.16 - 0.09) / 2.0, 1e-15);
  Cylinder pole = round;
  pole.side = Cylinder::Side::outside;
  EXPECT_NEAR(time_to_reach({"pole", 0, pole}, Vec3(3.0, 0.0, 0.0), 0.0, Vec3(-2.0, 0.0, 0.0), 0.1), 1.2,
              1e-15);
  EXPECT_TRUE(std::isinf(time_to_reach({"pole", 0, pole}, Vec3(3.0, 0.7, 0.0), 0.0, Vec3(-2, 0, 0), 0.1)));
}

}  // namespace
}  // namespace grainproof::test
