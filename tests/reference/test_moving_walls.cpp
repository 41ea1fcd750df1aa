// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "reference_cpu/walls.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double force_tolerance = 1e-11;  // springs and dashpots of order 10 N

/// One sphere of diameter 0.2, stiffness 1000, dashpot 20.
Scene sphere_at(const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
  Scene scene = empty_scene(linear(1000.0, Damping{20.0}), 1e-4);
  add_particle(scene, 0.2, position, velocity);
  return scene;
}

void rub(Scene& scene, double coefficient) {
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.friction = DynamicFriction{coefficient};
  scene.contacts.set(0, 0, laws);
}

void add_floor(Scene& scene, const WallMotion& motion) {
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}, motion});
}

// k 0.01 = 10 N, and the floor's 0.3 m/s of approach on the dashpot: 6 N.
TEST(MovingWalls, TranslatingFloorPushesTheDashpotToo) {
  Scene scene = sphere_at({0.0, 0.0, 0.09});
  add_floor(scene, Translating{{0.0, 0.0, 0.3}});
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, 0.0, 16.0)).norm(), force_tolerance);
}

TEST(MovingWalls, BeltDragsWhatLiesOnItUntilItMovesAlong) {
  Scene scene = sphere_at({0.0, 0.0, 0.09});
  rub(scene, 0.5);
  add_floor(scene, Translating{{0.0, 0.7, 0.0}});
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, 5.0, 10.0)).norm(), force_tolerance);
  scene.particles[0].velocity = {0.0, 0.7, 0.0};
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, 0.0, 10.0)).norm(), force_tolerance);
}

/// Falls onto a floor of history friction, which it meets half-way through a step; both seen from something
/// that passes at `speed`.
Scene impact_seen_from(const Vec3& speed, Integrator integrator) {
  ContactLaws laws = linear(1e4, Restitution{0.6});
  laws.friction = HistoryFriction{0.4, 8e3, 0.5};
  Scene scene = empty_scene(laws, 1e-4);
  scene.run.integrator = integrator;
  scene.rotation = true;
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}, Translating{speed}});
  add_particle(scene, 0.1, {0.0, 0.0, 0.06005}, Vec3(0.5, 0.0, -1.0) + speed);
  return scene;
}

// Positions of up to 1 m round by 1e-16 in each of 800 steps.
TEST(MovingWalls, ImpactIsTheSameInEveryInertialFrame) {
  const Vec3 speed(0.7, -0.3, 2.0);
  for (const auto& [name, integrator] : integrator_names) {
    const Frame still = frame_after(impact_seen_from(Vec3::Zero(), integrator), 800);
    const Frame passing = frame_after(impact_seen_from(speed, integrator), 800);
    EXPECT_GT(still.velocity[0].z(), 0.5);
    EXPECT_LE((passing.velocity[0] - speed - still.velocity[0]).norm(), 1e-11) << name;
    EXPECT_LE((passing.position[0] - speed * passing.time - still.position[0]).norm(), 1e-12) << name;
    EXPECT_LE((passing.angular_velocity[0] - still.angular_velocity[0]).norm(), 1e-9) << name;
  }
}

// ω × R at the surface, not at the centre of the particle: R 1, ω 3 about z, at angle 0 along +y.
TEST(MovingWalls, TurningDrumCarriesAlongWithTheSpeedOfItsSurface) {
  Scene scene = sphere_at({0.91, 0.0, 0.0}, {0.0, 3.0, 0.0});
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.friction = StepFriction{100.0, 1e4};
  scene.contacts.set(0, 0, laws);
  const Cylinder drum{Vec3::Zero(), Vec3::UnitZ(), 1.0, Cylinder::Side::inside};
  scene.walls.push_back({"drum", 0, drum, Rotating{3.0}});
  EXPECT_LE((force_on(scene, 0) - Vec3(-10.0, 0.0, 0.0)).norm(), force_tolerance);
  scene.particles[0].velocity.setZero();
  EXPECT_LE((force_on(scene, 0) - Vec3(-10.0, 1e4 * 3.0 * 1e-4, 0.0)).norm(), force_tolerance);
}

// A turntable: ω 2 about z at 0.5 m along x carries along +y, whatever lies between.
TEST(MovingWalls, TurningPlaneCarriesAlongRoundItsPoint) {
  Scene scene = sphere_at({0.5, 0.3, 0.09}, {0.0, 1.0, 0.0});
  rub(scene, 0.5);
  scene.walls.push_back({"table", 0, Plane{{0.0, 0.3, 0.0}, Vec3::UnitZ()}, Rotating{2.0}});
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, 0.0, 10.0)).norm(), force_tolerance);
  scene.particles[0].velocity.y() = 0.9;
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, 5.0, 10.0)).norm(), force_tolerance);
}

TEST(MovingWalls, VibratingWallStartsWhereItIsDrawnAndIsItsVelocitysIntegral) {
  Scene scene = sphere_at({0.0, 0.0, 5.0});
  scene.walls.push_back(
      {"sieve", 0, Rectangle{{0.0, 0.0, 1.0}, {2.0, 3.0, 1.0}}, Vibrating{{0.1, 0.0, -0.2}, 5.0, 0.6}});
  reference::Walls walls(scene);
  EXPECT_EQ(walls[0].reference, Vec3(0.0, 0.0, 1.0));
  walls.move_to(0.03);
  const double angle = 2.0 * std::numbers::pi * 5.0 * 0.03 + 0.6;
  const Vec3 shift = Vec3(0.1, 0.0, -0.2) * (std::sin(angle) - std::sin(0.6));
  EXPECT_LE((walls[0].reference - Vec3(0.0, 0.0, 1.0) - shift).norm(), 1e-15);
  EXPECT_LE((std::get<Rectangle>(walls[0].shape).upper - Vec3(2.0, 3.0, 1.0) - shift).norm(), 1e-15);
  const Vec3 velocity = walls[0].velocity, now = walls[0].reference;
  walls.move_to(0.03 + 1e-6);
  EXPECT_LE(((walls[0].reference - now) / 1e-6 - velocity).norm(), 1e-3);  // half the acceleration of 220
  EXPECT_GT(velocity.norm(), 0.1);
}

// At step 1 the floor is where it is at that very time.
TEST(MovingWalls, ForcesAreTakenAtTheTimeOfTheStep) {
  Scene scene = sphere_at({0.0, 0.0, 0.09});
  scene.run.integrator = Integrator::euler_trapezoid;
  scene.run.step = 1e-2;
  add_floor(scene, Vibrating{{0.0, 0.0, 0.02}, 7.0, 0.4});
  const auto run = start(scene);
  run->advance(1);
  const Frame one = run->frame();
  run->advance(1);
  const double rate = 2.0 * std::numbers::pi * 7.0, angle = rate * 1e-2 + 0.4;
  const double overlap = 0.1 - one.position[0].z() + 0.02 * (std::sin(angle) - std::sin(0.4));
  const double separating = one.velocity[0].z() - 0.02 * rate * std::cos(angle);
  const double expected = 1000.0 * overlap - 20.0 * separating;
  const double force = sphere_mass(0.2) * (run->frame().velocity[0].z() - one.velocity[0].z()) / 1e-2;
  EXPECT_NEAR(force, expected, 1e-10);
  EXPECT_GT(std::abs(20.0 * 0.02 * rate), 10.0);
}

TEST(MovingWalls, RectangleThatTravelsAcrossAPeriodicFaceStillPushes) {
  Scene scene = sphere_at({0.1, 0.0, 0.0});
  scene.domain = {.lower = {0.0, -1.0, -1.0}, .upper = {1.0, 1.0, 1.0}};
  scene.domain.boundary[0] = Boundary::periodic;
  scene.particles[0].velocity.x() = 10.0;
  scene.walls.push_back(
      {"piston", 0, Rectangle{{0.005, -0.5, -0.5}, {0.005, 0.5, 0.5}}, Translating{{10.0, 0.0, 0.0}}});
  const auto run = start(scene);
  run->advance(2500);
  EXPECT_LT(run->frame().position[0].x(), 1.0);
  EXPECT_GT(run->frame().velocity[0].x(), 10.0 + 1e-3);
}

}  // namespace
}  // namespace grainproof::testing
