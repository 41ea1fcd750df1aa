// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

ContactLaws laws_that_remember() {
  HistoryFriction friction{0.4, 0.0, 0.5};
  friction.memory = SpringMemory::force;
  return {.normal = HertzNormal{Restitution{0.7}}, .friction = friction, .rolling = SpringRolling{0.1}};
}

/// Spheres that turn and rub in a box, some of them in touch with each other and with the walls.
Scene pile() {
  Scene scene = empty_scene({}, 5e-5);
  scene.materials[0].elasticity = Elasticity{1e7, 0.3};
  scene.contacts.set(0, 0, laws_that_remember());
  scene.rotation = true;
  scene.domain = {.lower = Vec3::Zero(), .upper = Vec3::Constant(0.45)};
  close_domain(scene);
  scene.gravity = ConstantGravity{{1.0, 0.0, -9.81}};
  Random random(5);
  for (int i = 0; i < 27; ++i) {
    const Vec3 site = 0.15 * (Vec3(i % 3, i / 3 % 3, i / 9) + Vec3::Constant(0.5));
    add_particle(scene, 0.145, site, random.in_box(Vec3::Constant(-2.0), Vec3::Constant(2.0)))
        .angular_velocity = random.in_box(Vec3::Constant(-9.0), Vec3::Constant(9.0));
  }
  return scene;
}

/// The scene that goes on from a state, its contacts with what they remember.
Scene from(Scene scene, const State& state) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    scene.particles[i].position = state.position[i];
    scene.particles[i].velocity = state.velocity[i];
    scene.particles[i].angular_velocity = state.angular_velocity[i];
  }
  scene.remembered = state.contacts;
  std::ranges::sort(scene.remembered, {},
                    [](const ContactMemory& memory) { return std::pair(memory.first, memory.second); });
  return scene;
}

/// Largest difference of velocities after 200 more steps.
double difference(const Frame& one, const Frame& other) {
  double largest = 0.0;
  for (std::size_t i = 0; i < one.velocity.size(); ++i)
    largest = std::max(largest, (one.velocity[i] - other.velocity[i]).norm());
  return largest;
}

// The springs at the start are already turned into their planes and within their limits (the normal force has
// another dashpot by half a step's velocity), so what goes on is what would have gone on but for round-off.
TEST(Remembered, RunGoesOnAsIfItHadNeverStopped) {
  const auto run = start(pile());
  run->advance(400);
  const State state = run->state();
  ASSERT_GT(state.contacts.size(), 20u);
  const auto goes_on = start(from(pile(), state));
  Scene forgetful = from(pile(), state);
  forgetful.remembered.clear();
  const auto forgets = start(forgetful);
  run->advance(200);
  goes_on->advance(200);
  forgets->advance(200);
  EXPECT_LE(difference(run->frame(), goes_on->frame()), 1e-5);
  EXPECT_GT(difference(run->frame(), forgets->frame()), 1e-3);
}

/// Two spheres overlapping by 0.01 along x, at rest, and a floor in which the first stands.
Scene resting_pair() {
  ContactLaws laws = linear(1000.0, Damping{4.0});
  laws.friction = HistoryFriction{0.5, 1000.0, 0.5};
  Scene scene = empty_scene(laws, 1e-4);
  add_particle(scene, 0.1, Vec3::Zero());
  add_particle(scene, 0.1, {0.09, 0.0, 0.0});
  add_plane(scene, {0.0, 0.0, -0.045}, Vec3::UnitZ());
  return scene;
}

// 10 N along x from the overlap, 1 N from the spring; its part along the normal is turned out.
TEST(Remembered, SpringPullsInTheVeryFirstForces) {
  Scene scene = resting_pair();
  scene.walls.clear();
  scene.remembered = {{1, 2, 0, {0.002, 0.001, 0.0}}};
  EXPECT_LE((force_on(scene, 1) - Vec3(10.0, -1.0, 0.0)).norm(), 1e-10);
  const ContactMemory memory = start(scene)->state().contacts.at(0);
  EXPECT_LE((memory.tangential_displacement - Vec3(0.0, 0.001, 0.0)).norm(), 1e-17);
}

// 0.5 · 10 N where the spring would pull 8 N.
TEST(Remembered, SpringIsLimitedInTheVeryFirstForces) {
  Scene scene = resting_pair();
  scene.walls.clear();
  scene.remembered = {{1, 2, 0, {0.0, 0.008, 0.0}}};
  EXPECT_LE((force_on(scene, 1) - Vec3(10.0, -5.0, 0.0)).norm(), 1e-10);
}

TEST(Remembered, WallsAreNamedByTheirIndex) {
  Scene scene = resting_pair();
  scene.particles.resize(1);
  scene.remembered = {{1, -1, 0, {0.0, 0.001, 0.0}}};
  EXPECT_LE((force_on(scene, 0) - Vec3(0.0, -1.0, 5.0)).norm(), 1e-10);
}

void expect_refused(const ContactMemory& memory, const std::string& words) {
  Scene scene = resting_pair();
  scene.remembered = {memory};
  const Support support = reference::ReferenceEngine().supports(scene, {});
  EXPECT_FALSE(support);
  EXPECT_NE(support.because.find(words), std::string::npos) << support.because;
}

TEST(Remembered, ContactThatIsNoneIsRefused) {
  Scene scene = resting_pair();
  scene.remembered = {{1, 2, 0, Vec3::Zero()}, {1, -1, 0, Vec3::Zero()}};
  EXPECT_TRUE(reference::ReferenceEngine().supports(scene, {}));
  scene.remembered.push_back(scene.remembered.back());
  EXPECT_NE(reference::ReferenceEngine().supports(scene, {}).because.find("twice"), std::string::npos);
  expect_refused({1, 3, 0, Vec3::Zero()}, "not both of them are there");
  expect_refused({2, 1, 0, Vec3::Zero()}, "not both of them are there");
  expect_refused({1, -2, 0, Vec3::Zero()}, "not both of them are there");
  scene.remembered.clear();
  scene.particles[1].position.x() = 0.1001;
  scene.remembered = {{1, 2, 0, Vec3::Zero()}};
  EXPECT_NE(reference::ReferenceEngine().supports(scene, {}).because.find("do not touch"), std::string::npos);
}

TEST(Remembered, WhatNoLawKeepsIsRefused) {
  expect_refused({1, 2, 0, Vec3::Zero(), 1e-3}, "none of its laws keeps");
  expect_refused({1, 2, 0, Vec3::Zero(), 0.0, Vec3::UnitY()}, "none of its laws keeps");
  expect_refused({1, 2, 7, Vec3::Zero()}, "none of its laws keeps");
}

}  // namespace
}  // namespace grainproof::testing
