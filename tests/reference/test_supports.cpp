// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "model/errors.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

Scene small_scene() {
  Scene scene = empty_scene(linear(1e3, Restitution{0.5}), 1e-4);
  add_particle(scene, 0.2, Vec3::Zero());
  add_particle(scene, 0.1, {1.0, 0.0, 0.0});
  return scene;
}

void expect_refused(const Scene& scene, const std::string& words) {
  reference::ReferenceEngine engine;
  const Support support = engine.supports(scene, {});
  EXPECT_FALSE(support);
  EXPECT_NE(support.because.find(words), std::string::npos) << support.because;
  EXPECT_THROW(engine.start(scene, {}), InputRefused);
}

TEST(Supports, OrdinaryScene) {
  EXPECT_TRUE(reference::ReferenceEngine().supports(small_scene(), {}));
}

// Two ranges of the largest pair, which is two of the particle of 0.2 m.
TEST(Supports, PeriodMustHoldTwoRangesOfTheLargestPair) {
  Scene scene = small_scene();
  scene.domain = {.lower = {-5.0, -0.2, -5.0}, .upper = {5.0, 0.2, 5.0}};
  scene.domain.boundary[1] = Boundary::periodic;
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  scene.domain.upper.y() = 0.199;
  expect_refused(scene, "too small");
}

TEST(Supports, PeriodCountsEffectDiametersOnlyWithCohesion) {
  Scene scene = small_scene();
  scene.domain = {.lower = {-5.0, -0.25, -5.0}, .upper = {5.0, 0.25, 5.0}};
  scene.domain.boundary[1] = Boundary::periodic;
  scene.particles[0].effect_diameter = 0.3;
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  ContactLaws sticky = scene.contacts.at(0, 0);
  sticky.cohesion = LinearCohesion{1.0};
  scene.contacts.set(0, 0, sticky);
  expect_refused(scene, "0.6 m");
}

TEST(Supports, PlaneAcrossAPeriodicAxisIsRefused) {
  Scene scene = small_scene();
  scene.domain.boundary[0] = Boundary::periodic;
  add_plane(scene, {0.0, -5.0, 0.0}, Vec3::UnitY());
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  add_plane(scene, {-5.0, 0.0, 0.0}, Vec3(0.6, 0.8, 0.0));
  expect_refused(scene, "periodic x axis");
}

TEST(Supports, RectangleNearlyAsLongAsAPeriodIsRefused) {
  Scene scene = small_scene();
  scene.domain.boundary[0] = Boundary::periodic;
  scene.walls.push_back({"plate", 0, Rectangle{{-9.95, 0.0, 0.0}, {9.95, 1.0, 0.0}}});
  expect_refused(scene, "plate");
}

TEST(Supports, FixedParticleMustRest) {
  Scene scene = small_scene();
  scene.particles[1].fixed = true;
  scene.particles[1].velocity.x() = 1.0;
  expect_refused(scene, "fixed particle 2");
}

TEST(Supports, MissingContactLawsAreNamed) {
  Scene scene = small_scene();
  scene.materials.push_back({"steel", 7850.0});
  const ContactLaws laws = scene.contacts.at(0, 0);
  scene.contacts = ContactTable(2);
  scene.contacts.set(0, 0, laws);
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  scene.walls.push_back({"floor", 1, Plane{{0.0, 0.0, -1.0}, Vec3::UnitZ()}});
  expect_refused(scene, "'glass' and 'steel'");
}

TEST(Supports, MaterialsThatNeverMeetNeedNoLaws) {
  Scene scene = small_scene();
  scene.particles.resize(1);
  scene.contacts = ContactTable(1);
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
}

TEST(Supports, ClampedContactWithoutReboundIsRefused) {
  Scene scene = small_scene();
  scene.contacts.set(0, 0, linear(1e3, Restitution{0.0}, true));
  expect_refused(scene, "restitution 0");
  scene.contacts.set(0, 0, linear(1e3, Restitution{0.0}));
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
}

TEST(Supports, AngularVelocityNeedsRotationAndAFreeParticle) {
  Scene scene = small_scene();
  scene.particles[1].angular_velocity.z() = 1.0;
  expect_refused(scene, "particle 2 has an angular velocity");
  scene.rotation = true;
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  scene.particles[1].fixed = true;
  expect_refused(scene, "fixed particle 2");
}

Scene hertz_scene(Dissipation dissipation, const FrictionLaw& friction) {
  Scene scene = small_scene();
  scene.materials[0].elasticity = Elasticity{1e9, 0.3};
  scene.contacts.set(0, 0, {.normal = HertzNormal{dissipation}, .friction = friction});
  return scene;
}

TEST(Supports, HertzContactNeedsElasticityAndARestitution) {
  Scene scene = hertz_scene(Restitution{0.5}, HistoryFriction{0.3, 0.0, 1.0});
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  scene.materials[0].elasticity.reset();
  expect_refused(scene, "elasticity of 'glass'");
  expect_refused(hertz_scene(Damping{1.0}, Frictionless{}), "or from a damping ratio");
  expect_refused(hertz_scene(Restitution{0.0}, Frictionless{}), "above 0");
  EXPECT_TRUE(reference::ReferenceEngine().supports(hertz_scene(DampingRatio{0.0}, Frictionless{}), {}));
}

TEST(Supports, FrictionThatNeedsALinearContactTimeIsRefusedOnHertzContacts) {
  EXPECT_TRUE(reference::ReferenceEngine().supports(hertz_scene(Restitution{0.5}, DynamicFriction{0.3}), {}));
  expect_refused(hertz_scene(Restitution{0.5}, CollisionTimeFriction{0.3, 1e3}), "contact time");
  expect_refused(hertz_scene(Restitution{0.5}, DampedFriction{0.3, 1e3}), "contact time");
}

TEST(Supports, LinearContactNeedsATangentialStiffnessForHistory) {
  Scene scene = small_scene();
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.friction = HistoryFriction{0.3, 0.0, 1.0};
  scene.contacts.set(0, 0, laws);
  expect_refused(scene, "tangential stiffness");
}

TEST(Supports, OnlyPlanesAndCylindersTurnAndOnlyWhereTheyHaveNoPeriod) {
  Scene scene = small_scene();
  scene.walls.push_back({"table", 0, Plane{{0.0, 0.0, -1.0}, Vec3::UnitZ()}, Rotating{1.0}});
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  scene.domain.boundary[0] = Boundary::periodic;
  expect_refused(scene, "'table' cannot turn");
  scene.domain.boundary[0] = Boundary::open;
  scene.walls[0].shape = Rectangle{{-1.0, -1.0, -1.0}, {1.0, 1.0, -1.0}};
  expect_refused(scene, "rectangle");
}

TEST(Supports, CylinderFollowsThePeriodAndHoldsTheLargestParticle) {
  Scene scene = small_scene();
  scene.domain.boundary[0] = Boundary::periodic;
  scene.walls.push_back({"pipe", 0, Cylinder{Vec3::Zero(), Vec3::UnitX(), 0.5, Cylinder::Side::inside}});
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  scene.walls[0].shape = Cylinder{Vec3::Zero(), Vec3(0.6, 0.8, 0.0), 0.5, Cylinder::Side::inside};
  expect_refused(scene, "periodic x axis");
  scene.walls[0].shape = Cylinder{Vec3::Zero(), Vec3::UnitY(), 10.0, Cylinder::Side::inside};
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  scene.walls[0].motion = Translating{{0.1, 0.0, 0.0}};
  expect_refused(scene, "periodic x axis");
  scene.walls[0].motion = Still{};
  scene.walls[0].shape = Cylinder{Vec3::Zero(), Vec3::UnitY(), 9.95, Cylinder::Side::outside};
  expect_refused(scene, "periodic x axis");
  scene.walls[0].shape = Cylinder{Vec3::Zero(), Vec3::UnitX(), 0.1, Cylinder::Side::inside};
  expect_refused(scene, "does not fit into the cylinder");
}

TEST(Supports, WhatTurnsNeedsRotation) {
  Scene scene = small_scene();
  scene.orientation = OrientationUpdate::exponential;
  expect_refused(scene, "orientations need");
  scene.orientation = OrientationUpdate::none;
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.rolling = SpringRolling{0.1};
  scene.contacts.set(0, 0, laws);
  expect_refused(scene, "needs a scene with rotation");
  scene.rotation = true;
  expect_refused(scene, "friction with history");
  laws.friction = HistoryFriction{0.3, 1e3, 0.0};
  scene.contacts.set(0, 0, laws);
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
}

TEST(Provenance, NamesEngineAndPrecision) {
  const reference::ReferenceEngine engine;
  EXPECT_EQ(engine.name(), "reference");
  EXPECT_EQ(engine.provenance().precision, "double");
  EXPECT_EQ(engine.provenance().unit_roundoff, std::ldexp(1.0, -53));
  EXPECT_FALSE(engine.provenance().version.empty());
}

}  // namespace
}  // namespace grainproof::testing
