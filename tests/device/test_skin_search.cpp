// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "crowds.hpp"
#include "opencl/skin_search.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

/// A world in which a list has so many entries, and lasts as long as it takes to go half the skin.
struct World {
  double in_touch, shell_entries, steps_a_diameter;

  double entries(double skin) const {
    return in_touch + shell_entries * (std::pow(1.0 + skin / diameter, 3) - 1.0);
  }
  std::int64_t lifetime(double skin) const {
    return std::llround(std::max(steps_a_diameter * skin / diameter, 1.0));
  }
  double work(double skin) const { return entries(skin) + 300.0 / static_cast<double>(lifetime(skin)); }

  double found(double first) const {
    SkinSearch search(diameter, first);
    for (int list = 0; list < 100; ++list) search.learn(entries(search.skin()), lifetime(search.skin()));
    return search.skin();
  }
  double least_work() const {
    double least = 1e300;
    for (double skin = 0.004 * diameter; skin <= SkinSearch::widest * diameter; skin *= 1.01)
      least = std::min(least, work(skin));
    return least;
  }
};

constexpr World gas{0.0, 0.8, 250.0}, restless{0.0, 2.0, 60.0}, settled{6.0, 5.0, 1e6},
    flowing{6.0, 5.0, 3e4};

// Three in a hundred is what the search itself does not care about, the rest is the spacing of its
// candidates.
TEST(SkinSearch, ComesWithinATenthOfTheLeastWork) {
  for (const World& world : {gas, restless, settled, flowing})
    for (const double first : {0.01, 0.1, 0.3})
      EXPECT_LT(world.work(world.found(first * diameter)), 1.1 * world.least_work()) << first;
}

TEST(SkinSearch, TakesWideOnesWhereListsAreShortLived) {
  EXPECT_GT(restless.found(0.1 * diameter), 0.15 * diameter);
  EXPECT_LT(settled.found(0.1 * diameter), 0.01 * diameter);
}

TEST(SkinSearch, AsksSeldomer) {
  SkinSearch search(diameter, 0.1 * diameter);
  EXPECT_TRUE(search.learn(8.0, 1000000));
  EXPECT_TRUE(search.learn(8.0, 1));
  EXPECT_FALSE(search.learn(8.0, 1000000));
}

TEST(SkinSearch, StaysAboveWhatIsNeeded) {
  SkinSearch free(diameter, 0.2 * diameter), bound(diameter, 0.2 * diameter, 0.1 * diameter);
  EXPECT_TRUE(free.learn(20.0, 1000000));
  EXPECT_LT(free.skin(), 0.05 * diameter);
  EXPECT_TRUE(bound.learn(20.0, 1000000));
  EXPECT_EQ(bound.skin(), 0.1 * diameter);
}

TEST(SkinSearch, LearnsFromListsThatHoldAtFixedAges) {
  EXPECT_EQ(SkinSearch::next_trial(0), 256);
  EXPECT_EQ(SkinSearch::next_trial(255), 256);
  EXPECT_EQ(SkinSearch::next_trial(256), 1024);
}

TEST(SkinSearch, BeginsWiderWhereSpheresAreFaster) {
  Scene scene = crowded_scene({});
  const double fast = first_skin(scene);
  for (Particle& p : scene.particles) p.velocity /= 4.0;
  EXPECT_NEAR(first_skin(scene), fast / 2.0, 1e-12);
  for (Particle& p : scene.particles) p.velocity = Vec3::Zero();
  EXPECT_NEAR(first_skin(scene), 0.1 * diameter, 1e-2 * diameter);
}

}  // namespace
}  // namespace grainproof::opencl::testing
