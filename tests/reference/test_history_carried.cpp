// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// Turning, rubbing, rolling, sticky spheres of three sizes, filling a box that is periodic along x or
/// closed, with a shaken floor and a rod that travels.
Scene crowd(bool periodic) {
  ContactLaws laws = linear(1e5, Restitution{0.6});
  laws.friction = HistoryFriction{0.4, 8e4, 0.5};
  laws.cohesion = LinearCohesion{2e3};
  laws.rolling = SpringRolling{0.05};
  Scene scene = empty_scene(laws, 5e-5);
  scene.rotation = true;
  scene.domain = {.lower = Vec3::Zero(), .upper = Vec3::Constant(0.6)};
  close_domain(scene);
  if (periodic) {
    scene.domain.boundary[0] = Boundary::periodic;
    scene.walls.erase(scene.walls.begin(), scene.walls.begin() + 2);
  }
  scene.walls[scene.walls.size() - 2].motion = Vibrating{{0.0, 0.0, 0.01}, 20.0, 0.0};
  const Cylinder rod{{0.3, 0.3, 0.0}, Vec3::UnitX(), 0.03, Cylinder::Side::outside};
  scene.walls.push_back({"rod", 0, rod, Translating{{0.0, 0.2, 0.5}}});
  scene.gravity = ConstantGravity{{2.0, 0.0, -9.81}};
  Random random(11);
  for (int i = 0; i < 64; ++i) {
    const Vec3 site = 0.15 * (Vec3(i % 4, i / 4 % 4, i / 16) + Vec3::Constant(0.5));
    const double diameter = 0.11 + 0.015 * (i % 3);
    Particle& particle =
        add_particle(scene, diameter, site, random.in_box(Vec3::Constant(-3.0), Vec3::Constant(3.0)));
    particle.effect_diameter = 1.05 * diameter;
    particle.angular_velocity = random.in_box(Vec3::Constant(-20.0), Vec3::Constant(20.0));
  }
  return scene;
}

struct Ending {
  std::uint64_t digest;
  std::size_t contacts;
  std::int64_t rebuilds;
};

Ending ending_with(Scene scene, NeighbourSearch search, double skin) {
  scene.run.neighbours = search;
  scene.run.skin = skin;
  const auto run = start(scene);
  run->advance(3000);
  return {run->digest(), run->state().contacts.size(), run->counters().list_rebuilds};
}

class HistoryCarried : public ::testing::TestWithParam<bool> {};

TEST_P(HistoryCarried, ToTheBitWhateverListIsRebuiltWhenever) {
  const Scene scene = crowd(GetParam());
  const Ending every_step = ending_with(scene, NeighbourSearch::all_pairs, 0.0);
  EXPECT_GT(every_step.contacts, 20u);
  EXPECT_EQ(every_step.rebuilds, 3000);
  EXPECT_EQ(ending_with(scene, NeighbourSearch::cells, 0.0).digest, every_step.digest);
  for (const double skin : {0.0, 0.1, 0.5}) {
    const Ending now_and_then = ending_with(scene, NeighbourSearch::verlet_list, skin * 0.1);
    EXPECT_EQ(now_and_then.digest, every_step.digest) << skin;
    EXPECT_LT(now_and_then.rebuilds, skin > 0.0 ? 1500 : 3001);
  }
}

TEST_P(HistoryCarried, WithItsOnsetsToTheBit) {
  Scene scene = crowd(GetParam());
  scene.run.integrator = Integrator::onset_corrected;
  const Ending every_step = ending_with(scene, NeighbourSearch::all_pairs, 0.0);
  EXPECT_EQ(ending_with(scene, NeighbourSearch::cells, 0.0).digest, every_step.digest);
  EXPECT_EQ(ending_with(scene, NeighbourSearch::verlet_list, 0.05).digest, every_step.digest);
}

INSTANTIATE_TEST_SUITE_P(Boxes, HistoryCarried, ::testing::Bool(), [](const auto& box) {
  return box.param ? std::string("Periodic") : std::string("Closed");
});

/// Held together by cohesion, wound up by its first spin, drifting along x.
Scene drifting_pair(bool periodic) {
  ContactLaws laws = linear(1e4, Restitution{0.9});
  laws.friction = HistoryFriction{2.0, 5e3, 0.0};
  laws.cohesion = LinearCohesion{5e3};
  Scene scene = empty_scene(laws, 5e-5);
  scene.rotation = true;
  scene.domain = {.lower = Vec3::Constant(-0.5), .upper = Vec3::Constant(0.5)};
  if (periodic)
    scene.domain.boundary[0] = Boundary::periodic;
  else
    scene.domain.upper.x() = 5.0;
  for (const double side : {-1.0, 1.0}) {
    Particle& particle = add_particle(scene, 0.1, {side * 0.0495, 0.0, 0.0}, {10.0, 0.0, 0.0});
    particle.effect_diameter = 0.11;
    particle.angular_velocity = {0.0, 0.0, side * 0.5 + 1.5};
  }
  return scene;
}

// Three periods; positions of up to 3 m round by 4e-16 a step, springs of 1e-4 m follow such velocities.
TEST(HistoryAcrossAPeriodicFace, IsThatOfThePairThatMeetsNoFace) {
  const auto across = start(drifting_pair(true)), beside = start(drifting_pair(false));
  double longest = 0.0;
  for (int n = 0; n < 600; ++n) {
    across->advance(10);
    beside->advance(10);
    const auto one = across->state().contacts, other = beside->state().contacts;
    ASSERT_EQ(one.size(), 1u);
    ASSERT_EQ(other.size(), 1u);
    const Vec3 spring = other[0].tangential_displacement;
    longest = std::max(longest, spring.norm());
    ASSERT_LE((one[0].tangential_displacement - spring).norm(), 1e-12) << n;
  }
  EXPECT_GT(longest, 1e-4);
  EXPECT_LT(across->frame().position[0].x(), 0.5);
  EXPECT_GT(beside->frame().position[0].x(), 2.5);
}

/// A sphere that grips a plate and is carried over its edge at x = 0, 0.5 m/s against a soft spring.
Scene over_an_edge() {
  ContactLaws laws = linear(1e4, Restitution{0.9});
  laws.friction = HistoryFriction{5.0, 10.0, 0.0};
  Scene scene = empty_scene(laws, 1e-4);
  scene.rotation = true;
  scene.walls.push_back({"plate", 0, Rectangle{{-1.0, -1.0, 0.0}, {0.0, 1.0, 0.0}}});
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_particle(scene, 0.1, {-0.01, 0.0, 0.049}, {0.5, 0.0, 0.0});
  return scene;
}

// The nearest point runs on from face to edge, so the spring grows by no more than the slip of a step,
// of which the sphere's 0.5 m/s and its turning have less than 1 m/s.
TEST(HistoryOverAnEdge, IsThatOfOneContact) {
  const auto run = start(over_an_edge());
  double longest = 0.0;
  Vec3 before = Vec3::Zero();
  while (run->frame().position[0].x() < 0.01) {
    run->advance(1);
    const auto contacts = run->state().contacts;
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_EQ(contacts[0].feature, 0);
    EXPECT_LE((contacts[0].tangential_displacement - before).norm(), 1e-4);
    before = contacts[0].tangential_displacement;
    longest = std::max(longest, before.norm());
  }
  EXPECT_GT(longest, 5e-3);
}

}  // namespace
}  // namespace grainproof::testing
