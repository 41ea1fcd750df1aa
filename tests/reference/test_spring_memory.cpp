// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/contact_force.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

using reference::ContactPoint;
using reference::ContactSprings;

/// k_t = 8 G* sqrt(R* δ) with R* 0.04; μ so large that nothing slides.
reference::PairLaws hertz_laws(SpringMemory memory) {
  Scene scene = empty_scene({}, 1e-5);
  scene.materials[0].elasticity = Elasticity{1.5e9, 0.25};
  HistoryFriction friction{1e3, 0.0, 0.0};
  friction.memory = memory;
  scene.contacts.set(0, 0, {.normal = HertzNormal{Restitution{0.5}}, .friction = friction});
  return reference::resolve(scene, 0, 0);
}

ContactPoint still_at(double overlap) {
  return {Vec3::UnitX(), overlap, Vec3::Zero(), 0.01, 0.04};
}

double stiffness_at(double overlap) {
  return 8.0 * (1.5e9 / 8.75) * std::sqrt(0.04 * overlap);
}

/// Friction along y of a spring that was stretched to 1e-6 at one overlap and is now at others.
double friction_after(SpringMemory memory, std::initializer_list<double> overlaps) {
  ContactSprings springs{.displacement = {0.0, 1e-6, 0.0}};
  double friction = 0.0;
  for (const double overlap : overlaps)
    friction = contact_force(hertz_laws(memory), still_at(overlap), 0.0, springs).friction.y();
  return friction;
}

TEST(SpringMemory, OfDisplacementFollowsTheStiffnessUpAndDown) {
  const double before = -stiffness_at(1e-4) * 1e-6;
  EXPECT_NEAR(friction_after(SpringMemory::displacement, {1e-4, 4e-4}), 2.0 * before, 1e-12 * -before);
  EXPECT_NEAR(friction_after(SpringMemory::displacement, {1e-4, 0.25e-4}), 0.5 * before, 1e-12 * -before);
}

TEST(SpringMemory, OfForceKeepsTheForceWhileTheContactIsLoaded) {
  const double before = -stiffness_at(1e-4) * 1e-6;
  EXPECT_NEAR(friction_after(SpringMemory::force, {1e-4, 4e-4}), before, 1e-12 * -before);
}

// Falls with the stiffness, and does not come back: 1 → 1/2 → 1/2.
TEST(SpringMemory, OfForceLetsTheForceFallWithTheStiffnessAndNotRiseAgain) {
  const double before = -stiffness_at(1e-4) * 1e-6;
  EXPECT_NEAR(friction_after(SpringMemory::force, {1e-4, 0.25e-4}), 0.5 * before, 1e-12 * -before);
  EXPECT_NEAR(friction_after(SpringMemory::force, {1e-4, 0.25e-4, 1e-4}), 0.5 * before, 1e-12 * -before);
}

// What is stretched now is stretched at the stiffness of now.
TEST(SpringMemory, OfForceAddsTheSlipOfAStepAtTheStiffnessOfTheMoment) {
  ContactSprings springs{.displacement = {0.0, 1e-6, 0.0}, .overlap = 1e-4};
  ContactPoint point = still_at(4e-4);
  point.relative_velocity = {0.0, 0.0, 0.1};
  contact_force(hertz_laws(SpringMemory::force), point, 1e-5, springs);
  EXPECT_NEAR(springs.displacement.y(), 0.5e-6, 1e-18);
  EXPECT_NEAR(springs.displacement.z(), 1e-6, 1e-18);
  EXPECT_EQ(springs.overlap, 4e-4);
}

/// A pair that strikes obliquely, from before it touches until it has parted.
Scene oblique_pair(const NormalLaw& normal, SpringMemory memory) {
  HistoryFriction friction{0.4, 3e4, 0.5};
  friction.memory = memory;
  Scene scene = empty_scene({.normal = normal, .friction = friction}, 2e-5);
  scene.materials[0].elasticity = Elasticity{1e8, 0.3};
  scene.rotation = true;
  add_particle(scene, 0.1, {-0.0501, 0.0, 0.0}, {1.0, 0.3, 0.0});
  add_particle(scene, 0.1, {0.0501, 0.01, 0.0});
  return scene;
}

TEST(SpringMemory, IsTheSameForLinearContacts) {
  const LinearNormal law{1e5, Restitution{0.8}};
  const Frame one = frame_after(oblique_pair(law, SpringMemory::displacement), 1500);
  const Frame other = frame_after(oblique_pair(law, SpringMemory::force), 1500);
  EXPECT_EQ(one.velocity, other.velocity);
  EXPECT_EQ(one.angular_velocity, other.angular_velocity);
}

TEST(SpringMemory, OfForceGoesAnotherWayThroughAHertzContact) {
  const HertzNormal law{Restitution{0.8}};
  const Frame one = frame_after(oblique_pair(law, SpringMemory::displacement), 1500);
  const Frame other = frame_after(oblique_pair(law, SpringMemory::force), 1500);
  EXPECT_GT((one.angular_velocity[0] - other.angular_velocity[0]).norm(), 1e-2);
}

TEST(SpringMemory, StateHoldsTheOverlapWhereTheForceIsKept) {
  for (const SpringMemory memory : {SpringMemory::displacement, SpringMemory::force}) {
    const auto run = start(oblique_pair(HertzNormal{Restitution{0.8}}, memory));
    run->advance(60);
    const Frame frame = run->frame();
    const double overlap = 0.1 - (frame.position[1] - frame.position[0]).norm();
    EXPECT_GT(overlap, 1e-4);
    const double expected = memory == SpringMemory::force ? overlap : 0.0;
    EXPECT_NEAR(run->state().contacts.at(0).overlap, expected, 1e-16);
  }
}

}  // namespace
}  // namespace grainproof::testing
