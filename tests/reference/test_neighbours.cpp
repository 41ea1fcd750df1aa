// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/neighbours/all_pairs.hpp"
#include "reference_cpu/neighbours/chain_cells.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

using namespace reference;

ContactLaws every_law() {
  ContactLaws laws = linear(1e5, Restitution{0.7});
  laws.friction = CollisionTimeFriction{0.4, 3e3};
  laws.cohesion = LinearCohesion{20.0};
  return laws;
}

/// A polydisperse gas on a jittered lattice that fills the box but touches nowhere.
Scene gas(const std::array<int, 3>& cells, std::initializer_list<int> periodic_axes) {
  Scene scene = empty_scene(every_law(), 5e-5);
  const double spacing = 0.14;
  scene.domain = {.lower = Vec3::Zero(), .upper = spacing * Vec3(cells[0], cells[1], cells[2])};
  close_domain(scene);
  for (const int axis : periodic_axes) scene.domain.boundary[axis] = Boundary::periodic;
  std::erase_if(scene.walls, [&](const Wall& wall) {
    const Vec3& normal = std::get<Plane>(wall.shape).normal;
    for (const int axis : periodic_axes)
      if (normal[axis] != 0.0) return true;
    return false;
  });
  Random random(5);
  for (int x = 0; x < cells[0]; ++x)
    for (int y = 0; y < cells[1]; ++y)
      for (int z = 0; z < cells[2]; ++z) {
        const Vec3 jitter = random.in_box(Vec3::Constant(0.49), Vec3::Constant(0.51));
        const double diameter = random.between(0.07, 0.13);
        const Vec3 velocity = random.in_box(Vec3::Constant(-1.5), Vec3::Constant(1.5));
        add_particle(scene, diameter, spacing * (Vec3(x, y, z) + jitter), velocity).effect_diameter =
            1.03 * diameter;
      }
  return scene;
}

std::uint64_t digest_with(Scene scene, NeighbourSearch search, double skin, std::int64_t steps) {
  scene.run.neighbours = search;
  scene.run.skin = skin;
  const auto run = start(scene);
  run->advance(steps);
  return run->digest();
}

/// Every way of finding neighbours, and every skin in units of the mean diameter, gives the same bits.
void expect_same_bits(const Scene& scene, std::int64_t steps) {
  const std::uint64_t expected = digest_with(scene, NeighbourSearch::all_pairs, 0.0, steps);
  EXPECT_EQ(digest_with(scene, NeighbourSearch::cells, 0.0, steps), expected);
  for (const double skin : {0.0, 0.1, 0.5})
    EXPECT_EQ(digest_with(scene, NeighbourSearch::verlet_list, skin * 0.1, steps), expected) << skin;
  EXPECT_EQ(digest_with(scene, NeighbourSearch::automatic, -1.0, steps), expected);
}

int particles_with_changed_speed(const Scene& scene, const Frame& frame) {
  int changed = 0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    changed += std::abs(frame.velocity[i].norm() - scene.particles[i].velocity.norm()) > 0.01;
  return changed;
}

TEST(Neighbours, GasInAClosedBoxMovesTheSameHoweverNeighboursAreFound) {
  const Scene scene = gas({6, 5, 4}, {});
  EXPECT_GT(particles_with_changed_speed(scene, frame_after(scene, 3000)), 100);
  expect_same_bits(scene, 3000);
}

TEST(Neighbours, OnsetsAreTheSameHoweverNeighboursAreFound) {
  Scene scene = gas({5, 5, 5}, {0, 1});
  scene.run.integrator = Integrator::onset_corrected;
  expect_same_bits(scene, 3000);
}

TEST(Neighbours, GasInAPeriodicBoxMovesTheSameHoweverNeighboursAreFound) {
  expect_same_bits(gas({5, 5, 5}, {0, 1, 2}), 3000);
}

TEST(Neighbours, ThinPeriodicSlabMovesTheSameHoweverNeighboursAreFound) {
  expect_same_bits(gas({12, 2, 6}, {0, 1}), 3000);
}

TEST(Neighbours, FallingBedMovesTheSameHoweverNeighboursAreFound) {
  Scene scene = gas({5, 5, 6}, {});
  for (Particle& particle : scene.particles) particle.velocity *= 0.1;
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  expect_same_bits(scene, 4000);
}

/// Particles thrown anywhere into boxes that hold one to seven cells along an axis.
TEST(Neighbours, ChainCellsListThePairsThatAllPairsList) {
  Random random(17);
  for (int sample = 0; sample < 200; ++sample) {
    Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1e-4);
    scene.domain = {.lower = {-0.3, 0.1, -2.0}, .upper = Vec3(-0.3, 0.1, -2.0)};
    for (int axis = 0; axis < 3; ++axis) {
      scene.domain.upper[axis] += random.between(0.41, 1.5);
      if (random.between(0.0, 1.0) < 0.5) scene.domain.boundary[axis] = Boundary::periodic;
    }
    for (int i = 0; i < 60; ++i)
      add_particle(scene, random.between(0.05, 0.2), random.in_box(scene.domain.lower, scene.domain.upper));
    scene.particles[3].fixed = scene.particles[40].fixed = true;
    const PeriodicBox box(scene.domain);
    const Bodies bodies = bodies_of(scene);
    const double skin = random.between(0.0, 0.1);
    PairList all, chained;
    list_all_pairs(bodies, box, skin, all);
    ChainCells chains;
    chains.fill(grid_over(bodies, box, 2.0 * largest_reach(scene) + skin), bodies);
    chains.list_pairs(bodies, box, skin, chained);
    ASSERT_GT(all.size(), 0u);
    ASSERT_EQ(all.size(), chained.size()) << "sample " << sample;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      ASSERT_EQ(all.last(i), chained.last(i)) << "sample " << sample;
    for (std::size_t pair = 0; pair < all.size(); ++pair) ASSERT_EQ(all.partner(pair), chained.partner(pair));
  }
}

/// One sphere moving at 1 m/s past a fixed one, 1/64 m a step.
std::int64_t rebuilds_after(std::int64_t steps, double skin, const Vec3& velocity) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1.0 / 64.0);
  scene.run.neighbours = NeighbourSearch::verlet_list;
  scene.run.skin = skin;
  add_particle(scene, 0.1, {0.0, 0.0, 0.0}).fixed = true;
  add_particle(scene, 0.1, {0.0, 1.0, 0.0}, velocity);
  const auto run = start(scene);
  run->advance(steps);
  return run->counters().list_rebuilds;
}

// Twice the displacement exceeds a skin of 10/64 m first after six steps; all numbers are exact.
TEST(Neighbours, ListIsRebuiltWhenTwiceTheDisplacementExceedsTheSkinAndNotBefore) {
  const Vec3 velocity(1.0, 0.0, 0.0);
  EXPECT_EQ(rebuilds_after(5, 10.0 / 64.0, velocity), 0);
  EXPECT_EQ(rebuilds_after(6, 10.0 / 64.0, velocity), 1);
  EXPECT_EQ(rebuilds_after(59, 10.0 / 64.0, velocity), 9);
  EXPECT_EQ(rebuilds_after(60, 10.0 / 64.0, velocity), 10);
}

TEST(Neighbours, ListWithoutSkinIsRebuiltWheneverSomethingMoves) {
  EXPECT_EQ(rebuilds_after(20, 0.0, {1.0, 0.0, 0.0}), 20);
  EXPECT_EQ(rebuilds_after(20, 0.0, Vec3::Zero()), 0);
}

// 16 steps of 1/64 m in which nothing else moves.
TEST(Neighbours, WallThatComesFromAfarIsNotMissed) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1.0 / 64.0);
  scene.run.neighbours = NeighbourSearch::verlet_list;
  scene.run.skin = 2.0 / 64.0;
  scene.walls.push_back({"piston", 0, Plane{{-0.25, 0.0, 0.0}, Vec3::UnitX()}, Translating{{1.0, 0.0, 0.0}}});
  add_particle(scene, 0.1, {0.045, 0.0, 0.0});
  add_particle(scene, 0.1, {5.0, 0.0, 0.0});
  const auto run = start(scene);
  run->advance(16);
  EXPECT_GT(run->frame().velocity[0].x(), 0.0);
}

TEST(Neighbours, OneParticleIsNeverSearchedFor) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1e-2);
  scene.run.neighbours = NeighbourSearch::cells;
  add_particle(scene, 0.1, Vec3::Zero(), {1.0, 0.0, 0.0});
  const auto run = start(scene);
  run->advance(100);
  EXPECT_EQ(run->counters().list_rebuilds, 0);
}

}  // namespace
}  // namespace grainproof::testing
