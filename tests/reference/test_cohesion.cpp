// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/laws/linear_cohesion.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double force_tolerance = 1e-12;  // everything at rest, forces of order 1

/// Bodies of 0.1, effect diameters 0.15 and 0.17, centres `distance` apart along y.
Scene sticky_pair(double distance) {
  ContactLaws laws = linear(1000.0, Damping{5.0});
  laws.cohesion = LinearCohesion{50.0};
  Scene scene = empty_scene(laws, 1e-4);
  add_particle(scene, 0.1, {0.0, 0.0, 0.0}).effect_diameter = 0.15;
  add_particle(scene, 0.1, {0.0, distance, 0.0}).effect_diameter = 0.17;
  return scene;
}

// E7: the force on the second body points back to the first.
TEST(Cohesion, AttractsWhileEffectSurfacesOverlap) {
  const Scene scene = sticky_pair(0.12);
  EXPECT_LE((force_on(scene, 1) - Vec3(0.0, -50.0 * 0.04, 0.0)).norm(), force_tolerance);
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, 50.0 * 0.04, 0.0)).norm(), force_tolerance);
}

TEST(Cohesion, GoesOnDuringBodyContact) {
  const Scene scene = sticky_pair(0.09);
  EXPECT_LE((force_on(scene, 1) - Vec3(0.0, 1000.0 * 0.01 - 50.0 * 0.07, 0.0)).norm(), force_tolerance);
}

TEST(Cohesion, EndsWhereEffectSurfacesPart) {
  EXPECT_EQ(force_on(sticky_pair(0.16 + 1e-9), 1), Vec3::Zero());
}

TEST(Cohesion, WallHasNoReachOfItsOwn) {
  Scene scene = sticky_pair(5.0);
  add_plane(scene, {0.0, -0.06, 0.0}, Vec3::UnitY());
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, -50.0 * (0.075 - 0.06), 0.0)).norm(), force_tolerance);
}

TEST(Cohesion, EffectDiameterWithoutCohesionDoesNothing) {
  Scene scene = sticky_pair(0.12);
  scene.contacts.set(0, 0, linear(1000.0, Damping{5.0}));
  EXPECT_EQ(force_on(scene, 1), Vec3::Zero());
}

TEST(Cohesion, OnlyTheMaterialsThatHaveItAttract) {
  Scene scene = sticky_pair(0.12);
  const ContactLaws sticky = scene.contacts.at(0, 0);
  scene.materials.push_back({"dry", 2000.0});
  scene.contacts = ContactTable(2);
  scene.contacts.set(0, 0, sticky);
  scene.contacts.set(0, 1, linear(1000.0, Damping{5.0}));
  scene.contacts.set(1, 1, linear(1000.0, Damping{5.0}));
  EXPECT_LT(force_on(scene, 1).y(), 0.0);
  scene.particles[1].material = 1;
  EXPECT_EQ(force_on(scene, 1), Vec3::Zero());
}

TEST(Cohesion, PotentialIsTheIntegralOfItsForce) {
  const reference::EffectSpring law{50.0};
  EXPECT_NEAR(law.potential(0.04), -0.5 * 50.0 * 0.04 * 0.04, 1e-15);
  EXPECT_EQ(law.force(0.04), -50.0 * 0.04);
}

}  // namespace
}  // namespace grainproof::testing
