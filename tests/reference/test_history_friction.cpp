// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/contact_force.hpp"
#include "reference_cpu/digest.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

using reference::ContactForce;
using reference::ContactPoint;
using reference::ContactSprings;
using reference::PairLaws;

constexpr double force_tolerance = 1e-14;         // forces of order 1, a few roundings
constexpr double displacement_tolerance = 1e-17;  // displacements of order 1e-3

/// k 1000, η 4, k_t 1000, η_t 2, μ 0.5. At the overlap of 0.01 below the limit is 5 N.
PairLaws laws_with(CoulombLimit limit, SpringTurn turn = SpringTurn::project_and_rescale) {
  ContactLaws laws = linear(1000.0, Damping{4.0});
  laws.friction = HistoryFriction{0.5, 1000.0, 0.5, limit, TorqueArm::radius, turn};
  return reference::resolve(empty_scene(laws, 1e-3), 0, 0);
}

ContactPoint point_with(const Vec3& relative_velocity, const Vec3& normal = Vec3::UnitX()) {
  return {normal, 0.01, relative_velocity, 1.0, 0.05};
}

constexpr std::array both_limits{CoulombLimit::spring, CoulombLimit::spring_and_dashpot};

// 0.001 + 0.5 · 0.002; 1000 · 0.002 + 2 · 0.5.
TEST(HistoryFriction, StickingIsSpringAndDashpotWhateverTheLimitIsOn) {
  for (const CoulombLimit limit : both_limits) {
    ContactSprings springs{.displacement = {0.0, 0.001, 0.0}};
    const ContactForce force = contact_force(laws_with(limit), point_with({0.0, 0.5, 0.0}), 0.002, springs);
    EXPECT_LE((springs.displacement - Vec3(0.0, 0.002, 0.0)).norm(), displacement_tolerance);
    EXPECT_LE((force.friction - Vec3(0.0, -3.0, 0.0)).norm(), force_tolerance);
    EXPECT_NEAR(force.normal, 10.0, force_tolerance);
  }
}

// Spring 4.5 N, dashpot 1 N, limit 5 N.
TEST(HistoryFriction, LimitOnTheSpringLetsTheDashpotPassIt) {
  ContactSprings springs{.displacement = {0.0, 0.0035, 0.0}};
  const ContactForce force =
      contact_force(laws_with(CoulombLimit::spring), point_with({0.0, 0.5, 0.0}), 0.002, springs);
  EXPECT_LE((springs.displacement - Vec3(0.0, 0.0045, 0.0)).norm(), displacement_tolerance);
  EXPECT_LE((force.friction - Vec3(0.0, -5.5, 0.0)).norm(), force_tolerance);
}

// The same: the sum is cut to 5 N, and the spring keeps 5 − 1 N of it.
TEST(HistoryFriction, LimitOnTheSumCutsTheSpringBackToWhatTheDashpotLeaves) {
  ContactSprings springs{.displacement = {0.0, 0.0035, 0.0}};
  const ContactForce force =
      contact_force(laws_with(CoulombLimit::spring_and_dashpot), point_with({0.0, 0.5, 0.0}), 0.002, springs);
  EXPECT_LE((springs.displacement - Vec3(0.0, 0.004, 0.0)).norm(), displacement_tolerance);
  EXPECT_LE((force.friction - Vec3(0.0, -5.0, 0.0)).norm(), force_tolerance);
}

// Spring 3-4-5 of 7.5 N before the limit of 5 N: two thirds of it remain, and no dashpot acts.
TEST(HistoryFriction, SlidingSpringPullsWithTheLimitAloneAndIsCutBackToIt) {
  ContactSprings springs{.displacement = {0.0, 0.0035, 0.006}};
  const ContactForce force =
      contact_force(laws_with(CoulombLimit::spring), point_with({0.0, 0.5, 0.0}), 0.002, springs);
  EXPECT_LE((force.friction - Vec3(0.0, -3.0, -4.0)).norm(), force_tolerance);
  EXPECT_LE((springs.displacement - Vec3(0.0, 0.003, 0.004)).norm(), displacement_tolerance);
}

// Approaching at 1 m/s adds 4 N to the normal force and so 2 N to the limit.
TEST(HistoryFriction, LimitFollowsTheNormalForceWithItsDashpot) {
  ContactSprings springs{.displacement = {0.0, 0.1, 0.0}};
  const ContactForce force =
      contact_force(laws_with(CoulombLimit::spring), point_with({-1.0, 0.0, 0.0}), 0.0, springs);
  EXPECT_LE((force.friction - Vec3(0.0, -7.0, 0.0)).norm(), force_tolerance);
}

// ζ = 3e-3 along z, n = (0, 0.6, 0.8): 2.4e-3 along n goes, 1.8e-3 remain along (0, −0.8, 0.6).
TEST(HistoryFriction, SpringTurnsByItsPartInThePlane) {
  ContactSprings springs{.displacement = {0.0, 0.0, 0.003}};
  const PairLaws laws = laws_with(CoulombLimit::spring, SpringTurn::project);
  const ContactForce force = contact_force(laws, point_with(Vec3::Zero(), {0.0, 0.6, 0.8}), 0.001, springs);
  EXPECT_LE((springs.displacement - Vec3(0.0, -0.00144, 0.00108)).norm(), displacement_tolerance);
  EXPECT_LE((force.friction - Vec3(0.0, 1.44, -1.08)).norm(), force_tolerance);
}

TEST(HistoryFriction, RescaledSpringTurnsWithoutGettingShorter) {
  ContactSprings springs{.displacement = {0.0, 0.0, 0.003}};
  const PairLaws laws = laws_with(CoulombLimit::spring, SpringTurn::project_and_rescale);
  const ContactForce force = contact_force(laws, point_with(Vec3::Zero(), {0.0, 0.6, 0.8}), 0.001, springs);
  EXPECT_LE((springs.displacement - Vec3(0.0, -0.0024, 0.0018)).norm(), displacement_tolerance);
  EXPECT_LE((force.friction - Vec3(0.0, 2.4, -1.8)).norm(), force_tolerance);
}

TEST(HistoryFriction, SpringAlongTheNormalLeavesNothing) {
  for (const SpringTurn turn : {SpringTurn::project, SpringTurn::project_and_rescale}) {
    ContactSprings springs{.displacement = {0.003, 0.0, 0.0}};
    contact_force(laws_with(CoulombLimit::spring, turn), point_with(Vec3::Zero()), 0.001, springs);
    EXPECT_EQ(springs.displacement, Vec3::Zero());
  }
}

/// Two spheres overlapping by 0.01 along x, the second slipping along y.
Scene slipping_pair() {
  ContactLaws laws = linear(1000.0, Damping{4.0});
  laws.friction = HistoryFriction{0.5, 1000.0, 0.5};
  Scene scene = empty_scene(laws, 1e-4);
  add_particle(scene, 0.1, Vec3::Zero());
  add_particle(scene, 0.1, {0.09, 0.0, 0.0}, {0.0, 0.5, 0.0});
  return scene;
}

TEST(HistoryFriction, FirstEvaluationStretchesNoSpring) {
  const auto run = start(slipping_pair());
  ASSERT_EQ(run->state().contacts.size(), 1u);
  EXPECT_EQ(run->state().contacts[0].tangential_displacement, Vec3::Zero());
  EXPECT_LE((force_on(slipping_pair(), 1) - Vec3(10.0, -1.0, 0.0)).norm(), 1e-10);
}

// Half a step's 1 N of the dashpot slows both of 1.05 kg by 1e-4 of the slip; the pair turns by 6e-4.
TEST(HistoryFriction, OneStepStretchesTheSpringByTheSlip) {
  const auto run = start(slipping_pair());
  run->advance(1);
  const ContactMemory memory = run->state().contacts.at(0);
  EXPECT_EQ(memory.first, 1);
  EXPECT_EQ(memory.second, 2);
  EXPECT_EQ(memory.feature, 0);
  EXPECT_NEAR(memory.tangential_displacement.y(), 0.5e-4, 2e-4 * 0.5e-4);
  const Frame frame = run->frame();
  EXPECT_NEAR(memory.tangential_displacement.dot(frame.position[1] - frame.position[0]), 0.0, 1e-20);
}

TEST(HistoryFriction, ContactsThatPartAreForgotten) {
  Scene scene = slipping_pair();
  scene.particles[1].velocity.x() = 5.0;
  const auto run = start(scene);
  run->advance(10);
  EXPECT_EQ(run->state().contacts.size(), 1u);
  run->advance(40);
  EXPECT_TRUE(run->state().contacts.empty());
}

TEST(HistoryFriction, WallsAreRememberedByTheirIndex) {
  Scene scene = slipping_pair();
  add_plane(scene, {0.0, 0.0, -1.0}, Vec3::UnitZ());
  scene.walls.push_back({"table", 0, Rectangle{{-1.0, -1.0, -0.045}, {1.0, 1.0, -0.045}}});
  const auto run = start(scene);
  run->advance(1);
  const std::vector<ContactMemory> contacts = run->state().contacts;
  ASSERT_EQ(contacts.size(), 3u);
  EXPECT_EQ(contacts[1].first, 1);
  EXPECT_EQ(contacts[2].first, 2);
  EXPECT_EQ(contacts[1].second, -2);
  EXPECT_EQ(contacts[2].second, -2);
  EXPECT_NEAR(contacts[2].tangential_displacement.y(), 0.5e-4, 2e-4 * 0.5e-4);
}

TEST(HistoryFriction, DigestSeesSpringAndSpin) {
  Scene scene = slipping_pair();
  scene.rotation = true;
  const State state = start(scene)->state();
  State stretched = state, spinning = state;
  stretched.contacts.at(0).tangential_displacement.z() = 1e-9;
  spinning.angular_velocity.at(1).x() = 1e-9;
  EXPECT_NE(reference::digest_of(stretched), reference::digest_of(state));
  EXPECT_NE(reference::digest_of(spinning), reference::digest_of(state));
}

}  // namespace
}  // namespace grainproof::testing
