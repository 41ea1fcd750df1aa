// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "model/errors.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// So many turning, rubbing, rolling spheres that they are numbered along the cells, and every list new: they
/// are packed closely, fall on a floor, and their ids are shuffled in space.
Scene shuffled_bed(SumOrder order) {
  ContactLaws laws = linear(1e5, Restitution{0.6});
  laws.friction = HistoryFriction{0.4, 8e4, 0.5};
  laws.rolling = SpringRolling{0.05};
  Scene scene = empty_scene(laws, 2e-5);
  scene.rotation = true;
  scene.orientation = OrientationUpdate::exponential;
  scene.run.order = order;
  scene.run.skin = 0.0;
  scene.domain = {.lower = Vec3::Zero(), .upper = {1.7, 1.7, 3.0}};
  scene.domain.boundary[0] = Boundary::periodic;
  scene.domain.boundary[1] = Boundary::periodic;
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  std::vector<int> sites(17 * 17 * 17);
  for (std::size_t i = 0; i < sites.size(); ++i) sites[i] = static_cast<int>(i);
  std::shuffle(sites.begin(), sites.end(), std::mt19937_64(3));
  Random random(4);
  for (const int i : sites) {
    const Vec3 site = 0.1 * (Vec3(i % 17, i / 17 % 17, i / 289) + Vec3::Constant(0.49));
    Particle& particle = add_particle(scene, random.between(0.098, 0.102), site,
                                      random.in_box(Vec3::Constant(-1.0), Vec3::Constant(1.0)));
    particle.angular_velocity = random.in_box(Vec3::Constant(-9.0), Vec3::Constant(9.0));
  }
  return scene;
}

/// Of the largest differences over all particles or contacts, the largest.
template <class Vectors>
double difference(const Vectors& one, const Vectors& other) {
  EXPECT_EQ(one.size(), other.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) largest = std::max(largest, (one[i] - other[i]).norm());
  return largest;
}

// 80 lists, three of them of renumbered bodies. Sums of a dozen forces in other orders: some last digits of
// 3 m/s and 30 rad/s, which the contacts of 100 steps hardly magnify.
TEST(SpaceOrder, ChangesNoMoreThanTheOrderOfSums) {
  const auto sorted = start(shuffled_bed(SumOrder::fast)), plain = start(shuffled_bed(SumOrder::canonical));
  sorted->advance(80);
  plain->advance(80);
  EXPECT_EQ(sorted->counters().list_rebuilds, 80);
  EXPECT_NE(sorted->digest(), plain->digest());
  const State one = sorted->state(), other = plain->state();
  EXPECT_EQ(one.ids, other.ids);
  EXPECT_LE(difference(one.position, other.position), 1e-13);
  EXPECT_LE(difference(one.velocity, other.velocity), 1e-11);
  EXPECT_LE(difference(one.angular_velocity, other.angular_velocity), 1e-9);
  EXPECT_LE(difference(sorted->frame().velocity, one.velocity), 0.0);
}

TEST(SpaceOrder, TellsOfContactsAsIfBodiesHadNeverBeenRenumbered) {
  const auto sorted = start(shuffled_bed(SumOrder::fast)), plain = start(shuffled_bed(SumOrder::canonical));
  sorted->advance(80);
  plain->advance(80);
  const auto one = sorted->state().contacts, other = plain->state().contacts;
  ASSERT_EQ(one.size(), other.size());
  ASSERT_GT(one.size(), 5000u);
  double longest = 0.0, hardest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].first, other[i].first);
    ASSERT_EQ(one[i].second, other[i].second);
    longest = std::max(longest, one[i].tangential_displacement.norm());
    hardest = std::max(hardest, one[i].rolling_torque.norm());
    ASSERT_LE((one[i].tangential_displacement - other[i].tangential_displacement).norm(), 1e-13);
    ASSERT_LE((one[i].rolling_torque - other[i].rolling_torque).norm(), 1e-11);
  }
  EXPECT_GT(longest, 1e-5);
  EXPECT_GT(hardest, 1e-4);
}

TEST(SpaceOrder, OrientationsAndEnergiesFollowTheirBodies) {
  const auto sorted = start(shuffled_bed(SumOrder::fast), true);
  const auto plain = start(shuffled_bed(SumOrder::canonical), true);
  const double before = plain->ledger().kinetic;
  sorted->advance(40);
  plain->advance(40);
  const Frame one = sorted->frame(), other = plain->frame();
  for (std::size_t i = 0; i < one.orientation.size(); ++i)
    ASSERT_LE((one.orientation[i].coeffs() - other.orientation[i].coeffs()).norm(), 1e-12);
  EXPECT_NEAR(sorted->ledger().dissipated_tangential, plain->ledger().dissipated_tangential, 1e-11 * before);
  EXPECT_NEAR(sorted->ledger().gravity_work, plain->ledger().gravity_work, 1e-11 * before);
}

TEST(SpaceOrder, TroubleNamesTheParticlesOfTheScene) {
  Scene scene = shuffled_bed(SumOrder::fast);
  scene.particles[4000].velocity.z() = 1e6;
  const auto run = start(scene);
  try {
    run->advance(10);
    FAIL() << "nothing went wrong";
  } catch (const RunWentWrong& wrong) {
    EXPECT_EQ(wrong.particles.at(0), scene.particles[4000].id);
  }
}

// Sums of up to a dozen contacts are the same whatever list is used, where bodies are never renumbered.
TEST(SpaceOrder, CanonicalRunsHaveTheSameBitsForEverySkin) {
  Scene scene = shuffled_bed(SumOrder::canonical);
  const auto digest_with = [&](double skin) {
    scene.run.skin = skin;
    const auto run = start(scene);
    run->advance(60);
    return run->digest();
  };
  const std::uint64_t without = digest_with(0.0);
  EXPECT_EQ(digest_with(0.01), without);
  EXPECT_EQ(digest_with(0.05), without);
}

}  // namespace
}  // namespace grainproof::testing
