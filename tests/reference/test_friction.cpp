// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double diameter = 0.1, stiffness = 1000.0, eta = 5.0, step = 1e-4;
constexpr double force_tolerance = 1e-10;  // velocities of order 1 over a step of 1e-4, forces of order 10

/// Oblique pair without spin, overlap 0.01, normal (0.6, 0, 0.8), so a spring force of 10 N.
const Vec3 normal(0.6, 0.0, 0.8);

Scene oblique(const FrictionLaw& friction, const Vec3& velocity) {
  ContactLaws laws = linear(stiffness, Damping{eta});
  laws.friction = friction;
  Scene scene = empty_scene(laws, step);
  add_particle(scene, diameter, {0.2, -0.1, 0.3});
  add_particle(scene, diameter, Vec3(0.2, -0.1, 0.3) + 0.09 * normal, velocity);
  return scene;
}

Vec3 friction_on_second(const Scene& scene, double normal_force) {
  return force_on(scene, 1) - normal_force * normal;
}

double reduced_mass() {
  return 0.5 * sphere_mass(diameter);
}

// E17: a force proportional to the slip velocity instead of its unit vector fails the second speed.
TEST(Friction, DynamicForceIsCoulombsWhateverTheSlipSpeed) {
  for (const double speed : {0.3, 3.0}) {
    const Vec3 found = friction_on_second(oblique(DynamicFriction{0.4}, {0.0, speed, 0.0}), 10.0);
    EXPECT_LE((found - Vec3(0.0, -4.0, 0.0)).norm(), force_tolerance);
  }
}

TEST(Friction, FirstBodyGetsTheOpposite) {
  const Scene scene = oblique(DynamicFriction{0.4}, {0.3, 0.2, -0.5});
  EXPECT_LE((force_on(scene, 0) + force_on(scene, 1)).norm(), force_tolerance);
}

TEST(Friction, OpposesTheSlipAndLiesInTheTangentPlane) {
  const Vec3 slip = 0.5 * Vec3(-0.8, 0.0, 0.6) + Vec3(0.0, 1.2, 0.0);
  const double approach = 0.7;
  const Scene scene = oblique(DynamicFriction{0.4}, slip - approach * normal);
  const double normal_force = 10.0 + eta * approach;
  const Vec3 expected = -0.4 * normal_force * slip / 1.3;
  EXPECT_LE((friction_on_second(scene, normal_force) - expected).norm(), force_tolerance);
}

TEST(Friction, PullingDashpotStillRubs) {
  const double separating = 3.0;
  const Scene scene = oblique(DynamicFriction{0.4}, separating * normal + Vec3(0.0, 1.0, 0.0));
  EXPECT_LE((friction_on_second(scene, -5.0) - Vec3(0.0, -2.0, 0.0)).norm(), force_tolerance);
}

TEST(Friction, ContactWithoutSlipHasNone) {
  EXPECT_LE(friction_on_second(oblique(DynamicFriction{0.4}, Vec3::Zero()), 10.0).norm(), force_tolerance);
}

TEST(Friction, StepVariantIsStiffnessTimesSlipOfOneStep) {
  const Scene scene = oblique(StepFriction{0.4, 2e4}, {0.0, 0.3, 0.0});
  EXPECT_NEAR(friction_on_second(scene, 10.0).y(), -2e4 * 0.3 * step, force_tolerance);
}

TEST(Friction, CollisionTimeVariantIsStiffnessTimesSlipOfOneContact) {
  const Scene scene = oblique(CollisionTimeFriction{0.4, 100.0}, {0.0, 0.3, 0.0});
  const double contact_time = std::numbers::pi * std::sqrt(reduced_mass() / stiffness);
  EXPECT_NEAR(friction_on_second(scene, 10.0).y(), -100.0 * 0.3 * contact_time, force_tolerance);
}

TEST(Friction, DampedVariantAddsTheDashpotOnTheSlip) {
  const Scene scene = oblique(DampedFriction{0.4, 100.0}, {0.0, 0.3, 0.0});
  const double contact_time = std::numbers::pi * std::sqrt(reduced_mass() / stiffness);
  EXPECT_NEAR(friction_on_second(scene, 10.0).y(), -0.3 * (100.0 * contact_time + eta), force_tolerance);
}

TEST(Friction, EveryStaticVariantEndsAtCoulombsLimit) {
  for (const FrictionLaw& law :
       {FrictionLaw(StepFriction{0.4, 1e9}), FrictionLaw(CollisionTimeFriction{0.4, 1e9}),
        FrictionLaw(DampedFriction{0.4, 1e9})})
    EXPECT_NEAR(friction_on_second(oblique(law, {0.0, 0.3, 0.0}), 10.0).y(), -4.0, force_tolerance);
}

TEST(Friction, CohesionDoesNotCountAsNormalForce) {
  Scene scene = oblique(DynamicFriction{0.4}, {0.0, 0.3, 0.0});
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.cohesion = LinearCohesion{100.0};
  scene.contacts.set(0, 0, laws);
  EXPECT_LE((friction_on_second(scene, 10.0 - 1.0) - Vec3(0.0, -4.0, 0.0)).norm(), force_tolerance);
}

// Without tension every step's friction is μ times its normal force, so the changes of velocity keep
// that ratio to round-off: some 700 steps of a last digit of 5 m/s each.
TEST(Friction, SlidingImpactOnAWallLosesMuTimesItsNormalChange) {
  ContactLaws laws = linear(1e5, Restitution{0.8}, true);
  laws.friction = DynamicFriction{0.3};
  Scene scene = empty_scene(laws, 2e-5);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  const Vec3 start_velocity(3.0, -4.0, -1.0);
  add_particle(scene, diameter, {0.0, 0.0, 0.051}, start_velocity);
  const Vec3 change = frame_after(scene, 3000).velocity[0] - start_velocity;
  EXPECT_GT(change.z(), 1.7);
  EXPECT_LE((change.head<2>() - -0.3 * change.z() * Eigen::Vector2d(0.6, -0.8)).norm(),
            700 * 5.0 * 0x1p-53 * 4);
}

// E17: in the same impact the wall's dashpot has the whole mass, not half of it (which rebounds at 0.854).
TEST(Friction, WallRebound) {
  Scene scene = empty_scene(linear(1e5, Restitution{0.8}), 2e-6);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, diameter, {0.0, 0.0, 0.051}, {0.0, 0.0, -1.0});
  EXPECT_NEAR(frame_after(scene, 30000).velocity[0].z(), 0.8, 1e-4);
}

}  // namespace
}  // namespace grainproof::testing
