// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "comparisons/metrics/bed.hpp"
#include "comparisons/metrics/invariants.hpp"
#include "comparisons/metrics/pairs.hpp"
#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {
namespace {

Scene two_masses() {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{0.8}}}, 10.0);
  scene.particles = {particle(1, Vec3::Zero(), Vec3::Zero()),
                     particle(2, Vec3(1, 0, 0), Vec3::Zero(), false, 0.2)};
  run_for(scene, 1.0, 0.01);
  return scene;
}

/// The velocities of a first and a last frame, with empty ledgers.
Observations between(Vec3 a0, Vec3 b0, Vec3 a1, Vec3 b1) {
  Observations seen;
  seen.frames = {{0, 0.0, {Vec3::Zero(), Vec3(1, 0, 0)}, {a0, b0}},
                 {100, 1.0, {Vec3::Zero(), Vec3(1, 0, 0)}, {a1, b1}}};
  seen.initial_ledger = Ledger{};
  seen.final_ledger = Ledger{};
  return seen;
}

TEST(Momentum, ExchangeBetweenParticlesKeepsIt) {
  const Observations seen =
      between(Vec3(8, 0, 0), Vec3::Zero(), Vec3::Zero(), Vec3(1, 0, 0));  // masses 1 : 8
  EXPECT_NEAR(momentum_error(two_masses(), seen, {}).value, 0.0, 1e-15);
}

TEST(Momentum, ErrorIsRelativeToWhatThereWas) {
  const Observations seen = between(Vec3(8, 0, 0), Vec3::Zero(), Vec3::Zero(), Vec3(0.9, 0, 0));
  EXPECT_NEAR(momentum_error(two_masses(), seen, {}).value, 0.1, 1e-14);
}

TEST(Momentum, ImpulsesOfSupportsAndFieldsAccountForIt) {
  Observations seen = between(Vec3(1, 0, 0), Vec3::Zero(), Vec3(-1, 0, 3), Vec3::Zero());
  seen.final_ledger->support_impulse = Vec3(-2.0 * mass(), 0, 0);
  seen.final_ledger->field_impulse = Vec3(0, 0, 3.0 * mass());
  EXPECT_NEAR(momentum_error(two_masses(), seen, {}).value, 0.0, 1e-15);
  seen.final_ledger->support_impulse.setZero();
  EXPECT_GT(momentum_error(two_masses(), seen, {}).value, 0.1);
}

TEST(Momentum, NeedsALedger) {
  Observations seen = between(Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
  seen.final_ledger.reset();
  EXPECT_FALSE(momentum_error(two_masses(), seen, {}).exists());
}

TEST(Energy, DriftOfTheBalanceIsRelativeToTheLargestEntry) {
  Observations seen = between(Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
  seen.initial_ledger->kinetic = 10.0;
  seen.final_ledger->kinetic = 6.0;
  seen.final_ledger->dissipated_normal = 4.0;
  EXPECT_NEAR(energy_error(two_masses(), seen, {}).value, 0.0, 1e-15);
  seen.final_ledger->gravity_work = 0.1;
  EXPECT_NEAR(energy_error(two_masses(), seen, {}).value, -0.01, 1e-15);
}

TEST(LostParticles, AreThoseOutsideOrNotFiniteInAnyFrame) {
  Observations seen = between(Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
  EXPECT_EQ(lost_particles(two_masses(), seen, {}).value, 0.0);
  seen.frames[0].position[1] = Vec3(0, 0, -10.001);
  EXPECT_EQ(lost_particles(two_masses(), seen, {}).value, 0.5);
  seen.frames[0].position[1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(lost_particles(two_masses(), seen, {}).value, 0.5);
}

TEST(Bed, HeightIsTwiceTheCentreOverTheFloorWhereverGravityPoints) {
  Scene scene = two_masses();
  scene.gravity = ConstantGravity{Vec3(0, -9.81, 0)};
  Observations seen = between(Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
  seen.frames.back().position = {Vec3(0, -9, 0), Vec3(0, -6, 0)};
  EXPECT_NEAR(bed_height(scene, seen).value, 5.0, 1e-14);
}

std::size_t overlaps_by_all_pairs(const Scene& scene, const Frame& frame) {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) pairs += gap(scene, frame, {i, j, 0}) < 0.0;
  return pairs;
}

TEST(Bed, ContactNumberByCellsIsThatOfAllPairs) {
  for (const Boundary boundary : {Boundary::open, Boundary::periodic})
    for (const double width : {0.12, 0.25, 1.0}) {  // one, two and many cells an axis
      Scene scene = scene_of({LinearNormal{stiffness, Restitution{0.8}}}, width / 2.0);
      scene.domain.boundary = {boundary, boundary, boundary};
      std::mt19937 random(7);
      std::uniform_real_distribution<double> anywhere(-width / 2.0, width / 2.0);
      Observations seen;
      seen.frames.emplace_back();
      for (int i = 0; i < 400; ++i) {
        const Vec3 place(anywhere(random), anywhere(random), anywhere(random));
        scene.particles.push_back(particle(i + 1, place, Vec3::Zero()));
        seen.frames[0].position.push_back(place);
      }
      const auto pairs = static_cast<double>(overlaps_by_all_pairs(scene, seen.frames[0]));
      EXPECT_GT(pairs, 100.0);
      EXPECT_EQ(contact_number(scene, seen).value, 2.0 * pairs / 400.0);
    }
}

}  // namespace
}  // namespace grainproof::test
