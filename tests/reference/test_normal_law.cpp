// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/laws/linear_normal.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

using reference::damping_ratio;
using reference::damping_ratio_without_tension;
using reference::spring_dashpot;

// Velocities near 1 and a step of 1e-4 leave 1e-12 of a force of order 10.
constexpr double force_tolerance = 1e-10;

/// Diameters 0.1 at distance 0.09: overlap 0.01, spring 1000 · 0.01 = 10 N along x.
Scene pair(const Vec3& first_velocity, const Vec3& second_velocity, bool no_tension = false) {
  Scene scene = empty_scene(linear(1000.0, Damping{5.0}, no_tension), 1e-4);
  add_particle(scene, 0.1, {1.0, 0.0, 0.0}, first_velocity);
  add_particle(scene, 0.1, {1.09, 0.0, 0.0}, second_velocity);
  return scene;
}

void expect_pair_force(const Scene& scene, const Vec3& on_second) {
  EXPECT_LE((force_on(scene, 1) - on_second).norm(), force_tolerance);
  EXPECT_LE((force_on(scene, 0) + on_second).norm(), force_tolerance);
}

TEST(NormalLaw, SpringPushesTheBodiesApart) {
  expect_pair_force(pair({0, 0, 0}, {0, 0, 0}), {10.0, 0.0, 0.0});
}

TEST(NormalLaw, DashpotAddsToTheSpringOnApproach) {
  expect_pair_force(pair({0.3, 0, 0}, {-0.1, 0, 0}), {10.0 + 5.0 * 0.4, 0.0, 0.0});
}

TEST(NormalLaw, DashpotPullsOnSeparation) {
  expect_pair_force(pair({0, 0, 0}, {3.0, 0, 0}), {10.0 - 15.0, 0.0, 0.0});
}

TEST(NormalLaw, WithoutTensionItNeverPulls) {
  expect_pair_force(pair({0, 0, 0}, {3.0, 0, 0}, true), Vec3::Zero());
  expect_pair_force(pair({0, 0, 0}, {1.0, 0, 0}, true), {5.0, 0.0, 0.0});
}

TEST(NormalLaw, VelocityAcrossTheNormalDoesNotDamp) {
  expect_pair_force(pair({0, 2.0, 0}, {0, 0, -3.0}), {10.0, 0.0, 0.0});
}

TEST(NormalLaw, SeparateBodiesExertNothing) {
  Scene scene = pair({1.0, 0, 0}, {0, 0, 0});
  scene.particles[1].position.x() = 1.1 + 1e-12;
  expect_pair_force(scene, Vec3::Zero());
}

TEST(NormalLaw, UnequalDiametersOverlapByHalfTheirSumLessDistance) {
  Scene scene = pair({0, 0, 0}, {0, 0, 0});
  scene.particles[1].diameter = scene.particles[1].effect_diameter = 0.12;
  expect_pair_force(scene, {20.0, 0.0, 0.0});
}

// Andrews 2.17 by hand: ε = 0.8, k = 1e5, m = 1: η = 2 · 0.2231435513 · sqrt(1e5/(π² + 0.0497930446)).
TEST(NormalLaw, DampingFollowsFromRestitutionAndEffectiveMass) {
  const auto contact = spring_dashpot({1e5, Restitution{0.8}});
  EXPECT_NEAR(contact.damping_for(1.0), 44.8096643, 1e-6);
  EXPECT_NEAR(contact.damping_for(2.0), 2.0 * 44.8096643, 1e-6);
}

TEST(NormalLaw, PairOfUnequalMassesIsDampedWithItsReducedMass) {
  Scene scene = empty_scene(linear(1e4, Restitution{0.8}), 1e-4);
  add_particle(scene, 0.1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
  add_particle(scene, 0.05, {0.07, 0.0, 0.0});
  const double m1 = sphere_mass(0.1), m2 = sphere_mass(0.05);
  const double reduced = m1 * m2 / (m1 + m2), log = std::log(0.8);
  const double pi = std::numbers::pi;
  const double eta = -2.0 * log * std::sqrt(reduced * 1e4 / (pi * pi + log * log));
  expect_pair_force(scene, {1e4 * 0.005 + eta, 0.0, 0.0});
}

TEST(NormalLaw, FixedPartnerLeavesTheMovingMass) {
  Scene scene = empty_scene(linear(1e4, Restitution{0.8}), 1e-4);
  add_particle(scene, 0.1, {0.0, 0.0, 0.0}).fixed = true;
  add_particle(scene, 0.05, {0.07, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  const double log = std::log(0.8), pi = std::numbers::pi;
  const double eta = -2.0 * log * std::sqrt(sphere_mass(0.05) * 1e4 / (pi * pi + log * log));
  EXPECT_LE((force_on(scene, 1) - Vec3(1e4 * 0.005 + eta, 0.0, 0.0)).norm(), force_tolerance);
  EXPECT_EQ(force_on(scene, 0), Vec3::Zero());
}

TEST(NormalLaw, NoRestitutionIsCriticalDampingAndFullRestitutionNone) {
  EXPECT_EQ(damping_ratio(0.0), 1.0);
  EXPECT_EQ(damping_ratio(1.0), 0.0);
  EXPECT_EQ(damping_ratio_without_tension(1.0), 0.0);
}

// Schwager and Pöschel 2007: the clamped contact with the plain law's damping for 0.8 rebounds at
// 0.80810, and the critically damped one at exp(−2).
TEST(NormalLaw, ClampedContactHasItsOwnDamping) {
  EXPECT_NEAR(damping_ratio_without_tension(0.80810), damping_ratio(0.8), 5e-6);
  EXPECT_NEAR(damping_ratio_without_tension(std::exp(-2.0)), 1.0, 1e-6);
  EXPECT_GT(damping_ratio_without_tension(0.05), 1.0);
}

// Fine steps: the onset's first-order error is below 1e-4 of the approach speed.
TEST(NormalLaw, ClampedContactReboundsWithTheRestitutionAskedFor) {
  for (const double restitution : {0.9, 0.8, 0.3, 0.1}) {
    Scene scene = empty_scene(linear(1e5, Restitution{restitution}, true), 1e-6);
    add_plane(scene, Vec3::Zero(), Vec3::UnitX());
    add_particle(scene, 0.1, {0.06, 0.0, 0.0}, {-1.0, 0.0, 0.0});
    EXPECT_NEAR(frame_after(scene, 100000).velocity[0].x(), restitution, 1e-4);
  }
}

// 2 · 0.3 · sqrt(m/2 · k) with equal masses; the same dashpot as Damping of that value.
TEST(NormalLaw, DampingRatioIsAShareOfTheCriticalDashpot) {
  const auto approaching = [](Dissipation dissipation) {
    Scene scene = empty_scene(linear(1e4, dissipation), 1e-6);
    add_particle(scene, 0.1, {-0.0495, 0.0, 0.0}, {0.5, 0.0, 0.0});
    add_particle(scene, 0.1, {0.0495, 0.0, 0.0}, {-0.5, 0.0, 0.0});
    return force_on(scene, 1).x();
  };
  const double eta = 2.0 * 0.3 * std::sqrt(0.5 * sphere_mass(0.1) * 1e4);
  EXPECT_NEAR(approaching(DampingRatio{0.3}), 10.0 + eta, 1e-9);
  EXPECT_NEAR(approaching(DampingRatio{0.3}), approaching(Damping{eta}), 1e-9);
}

}  // namespace
}  // namespace grainproof::testing
