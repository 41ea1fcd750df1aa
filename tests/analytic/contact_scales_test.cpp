// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/contact_scales.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analytic/hertz.hpp"
#include "model/errors.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

constexpr double tight = 1e-14;  // a few dozen roundings, relative

TEST(ContactScales, SphereMassIsDensityTimesVolume) {
  EXPECT_NEAR(sphere_mass(2000.0, 0.1), 1.0471975511965976, tight);
}

TEST(ContactScales, EffectiveMassOfAnImmovablePartnerIsTheOther) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(effective_mass(2.0, infinite), 2.0);
  EXPECT_EQ(effective_mass(infinite, 2.0), 2.0);
  EXPECT_NEAR(effective_mass(2.0, 3.0), 1.2, tight);
}

TEST(ContactScales, DampingGivesBackItsRestitution) {
  for (double e : {1e-9, 0.01, 0.2, 0.5, 0.8, 0.99, 0.9999999, 1.0})
    EXPECT_NEAR(restitution_of(damping({1e5, Restitution{e}}, 1.047), 1e5, 1.047) / e, 1.0, 1e-13) << e;
}

TEST(ContactScales, NoTensionDampingGivesBackItsRestitution) {
  for (double e : {1e-4, 0.01, std::exp(-2.0), 0.2, 0.5, 0.8, 0.99, 0.9999999, 1.0})
    EXPECT_NEAR(no_tension_restitution_of(damping({1e5, Restitution{e}, true}, 1.047), 1e5, 1.047) / e, 1.0,
                1e-13)
        << e;
}

// Values printed by Schwager and Pöschel's closed form at the plain law's dashpot.
TEST(ContactScales, NoTensionReboundsHigherThanPlainAtEqualDamping) {
  const double eta = damping({1e5, Restitution{0.8}}, 1.047);
  EXPECT_NEAR(no_tension_restitution_of(eta, 1e5, 1.047), 0.80810, 5e-6);
  EXPECT_NEAR(no_tension_restitution_of(2.0 * std::sqrt(1.047e5), 1e5, 1.047), std::exp(-2.0), 1e-14);
}

TEST(ContactScales, RestitutionZeroIsCriticalDampingAndOutOfReachWithoutTension) {
  EXPECT_NEAR(damping({1e5, Restitution{0.0}}, 1.047), 2.0 * std::sqrt(1.047e5), 1e-10);
  EXPECT_EQ(restitution_of(2.0 * std::sqrt(1.047e5), 1e5, 1.047), 0.0);
  EXPECT_THROW(damping({1e5, Restitution{0.0}, true}, 1.047), InputRefused);
  EXPECT_THROW(damping({1e5, Restitution{1.1}}, 1.047), InputRefused);
  EXPECT_THROW(damping({1e5, Restitution{std::nan("")}}, 1.047), InputRefused);
}

TEST(ContactScales, DurationIsHalfTheDampedPeriod) {
  const double m = 1.047, k = 1e5, eta = 45.0;
  EXPECT_NEAR(contact_duration(k, eta, m), std::numbers::pi / std::sqrt(k / m - std::pow(eta / (2.0 * m), 2)),
              1e-16);
  EXPECT_NEAR(contact_duration(k, 1e4, m), std::numbers::pi * std::sqrt(m / k), 1e-16);
}

TEST(ShortestContact, IsNoneWhereNothingCanTouch) {
  Scene scene = glass_scene();
  EXPECT_FALSE(shortest_contact(scene));
  add_sphere(scene, {0, 0, 0}, {0, 0, 0});
  EXPECT_FALSE(shortest_contact(scene));
  scene.particles.front().fixed = true;
  add_sphere(scene, {0.2, 0, 0}, {0, 0, 0}, true);
  EXPECT_FALSE(shortest_contact(scene));
}

TEST(ShortestContact, TakesTheLightestPairAndNamesIt) {
  Scene scene = glass_scene();
  add_sphere(scene, {0, 0, 0}, {0, 0, 0}, true);
  add_sphere(scene, {1, 0, 0}, {0, 0, 0});
  const double m = sphere_mass(2000.0, 0.1);
  ASSERT_TRUE(shortest_contact(scene));
  EXPECT_NEAR(shortest_contact(scene)->effective_mass, m, tight);
  add_sphere(scene, {2, 0, 0}, {0, 0, 0});
  EXPECT_NEAR(shortest_contact(scene)->effective_mass, m / 2.0, tight);
  EXPECT_EQ(shortest_contact(scene)->between, "glass and glass");
}

TEST(ShortestContact, CountsWallsOfEveryMaterialPresent) {
  Scene scene = glass_scene();
  add_sphere(scene, {0, 0, 1}, {0, 0, 0});
  add_floor(scene);
  ASSERT_TRUE(shortest_contact(scene));
  EXPECT_EQ(shortest_contact(scene)->between, "glass and wall floor");
  const double expected =
      contact_duration(1e5, damping({1e5, Restitution{0.8}}, sphere_mass(2000, 0.1)), sphere_mass(2000, 0.1));
  EXPECT_EQ(shortest_contact(scene)->duration, expected);
}

TEST(DampingRatio, IsAShareOfTheCriticalDashpot) {
  const double m = 1.047, k = 1e5;
  EXPECT_NEAR(damping({k, DampingRatio{1.0}}, m), 2.0 * std::sqrt(m * k), 1e-12);
  EXPECT_EQ(restitution_of(damping({k, DampingRatio{1.0}}, m), k, m), 0.0);
  EXPECT_NEAR(damping({k, DampingRatio{0.3}}, m) / damping({k, DampingRatio{1.0}}, m), 0.3, 1e-15);
}

/// Of a Hertz contact the rebound is exp(-pi b/sqrt(1 - b²)) with b = γ sqrt(6/5) (hertz.14).
TEST(DampingRatio, OfAHertzContactGivesTheSameRebound) {
  const double ratio = 0.2, beta = ratio * std::sqrt(1.2);
  const double rebound = std::exp(-M_PI * beta / std::sqrt(1.0 - beta * beta));
  EXPECT_NEAR(hertz_damping_ratio(DampingRatio{ratio}) / hertz_damping_ratio(Restitution{rebound}), 1.0,
              1e-14);
  EXPECT_THROW(hertz_damping_ratio(Damping{1.0}), InputRefused);
}

}  // namespace
}  // namespace grainproof::analytic
