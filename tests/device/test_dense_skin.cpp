// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "crowds.hpp"
#include "device_fixture.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Seen {
  std::uint64_t digest;
  Counters counters;
};

Seen seen(Scene scene, double skin, int steps, int at_once) {
  scene.run.skin = skin;
  EngineOptions options = options_for(Precision::single_precision);
  options.path = Path::dense;
  OpenClEngine engine(options);
  const auto run = engine.start(scene, {});
  for (int done = 0; done < steps; done += at_once) run->advance(std::min(at_once, steps - done));
  run->synchronise();
  return {run->digest(), run->counters()};
}

Scene slow_gas(SumOrder order) {
  Scene scene = crowded_scene({});
  scene.run.order = order;
  scene.gravity = ConstantGravity{Vec3::Zero()};
  for (Particle& p : scene.particles) p.velocity *= 0.05;
  return scene;
}

constexpr double searched = RunSettings::searched_skin;

TEST(DenseSkin, IsFoundDuringTheRun) {
  const Seen found = seen(slow_gas(SumOrder::fast), searched, 400, 400);
  const Seen wide = seen(slow_gas(SumOrder::fast), 0.3 * diameter, 400, 400);
  EXPECT_LT(found.counters.skin, 0.2 * diameter);
  // Its lists last less long. How many pairs they hold is a matter of how full their slots are, in so small a crowd.
  EXPECT_GT(found.counters.list_rebuilds, 2 * wide.counters.list_rebuilds);
}

TEST(DenseSkin, OfASearchDoesNotDependOnHowStepsAreAskedFor) {
  const Seen once = seen(slow_gas(SumOrder::fast), searched, 600, 600);
  const Seen often = seen(slow_gas(SumOrder::fast), searched, 600, 37);
  EXPECT_EQ(once.counters.skin, often.counters.skin);
  EXPECT_EQ(once.counters.list_rebuilds, often.counters.list_rebuilds);
  EXPECT_EQ(once.digest, often.digest);
}

TEST(DenseSkin, OfASearchGivesTheBitsOfAnyOtherInCanonicalOrder) {
  const Scene scene = slow_gas(SumOrder::canonical);
  const Seen searching = seen(scene, searched, 600, 600), given = seen(scene, 0.1 * diameter, 600, 600);
  EXPECT_NE(searching.counters.skin, given.counters.skin);
  EXPECT_EQ(searching.digest, given.digest);
}

// A contact that ends is heard of only while its pair is listed.
TEST(DenseSkin, OfASearchIsNotBelowWhatOnsetsNeed) {
  Scene scene = slow_gas(SumOrder::canonical);
  scene.run.integrator = Integrator::onset_corrected;
  const Seen searching = seen(scene, searched, 600, 600), given = seen(scene, 0.2 * diameter, 600, 600);
  EXPECT_GE(searching.counters.skin, 0.1 * diameter);
  EXPECT_NE(searching.counters.skin, given.counters.skin);
  EXPECT_EQ(searching.digest, given.digest);
}

TEST(DenseMemory, IsAddedUp) {
  const Seen bed = seen(crowded_scene({.across = 20}), 0.1 * diameter, 10, 10);
  const double bytes = static_cast<double>(bed.counters.device_bytes) / 4000.0;
  EXPECT_GT(bytes, 96.0 + 24.0 + 12.0 + 8.0);  // two records, remainders, places of the list, ids and cells
  EXPECT_LT(bytes, 320.0);                     // so small a bed has not the fullest groups
}

}  // namespace
}  // namespace grainproof::opencl::testing
