// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <functional>

#include "reference_cpu/reference_engine.hpp"
#include "tests/device/crowds.hpp"
#include "tests/device/device_fixture.hpp"
#include "tests/device/driver_process.hpp"
#include "tests/device/varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

/// Those who have bits of their own on a crowd of many.
std::vector<std::unique_ptr<RestartableEngine>> crowd_engines() {
  std::vector<std::unique_ptr<RestartableEngine>> engines;
  engines.push_back(std::make_unique<reference::ReferenceEngine>());
  EngineOptions options = options_for(Precision::single_precision);
  options.path = Path::dense;
  engines.push_back(std::make_unique<OpenClEngine>(options));
  return engines;
}

Scene small_crowd(SumOrder order) {
  Scene scene = crowded_scene({.across = 7, .layers = 7});
  scene.run.order = order;
  return scene;
}

std::uint64_t digest_after(SteppingEngine& engine, const Scene& scene, std::int64_t steps) {
  const auto run = engine.start(scene, {});
  run->advance(steps);
  return run->digest();
}

class CrowdBits : public ::testing::TestWithParam<SumOrder> {};

TEST_P(CrowdBits, DoNotChangeInTwentyRuns) {
  const Scene scene = small_crowd(GetParam());
  for (const auto& engine : crowd_engines()) {
    const std::uint64_t once = digest_after(*engine, scene, 60);
    for (int again = 1; again < 20; ++again)
      ASSERT_EQ(digest_after(*engine, scene, 60), once) << engine->name() << ", run " << again;
  }
}

// What a sentinel and a recorder do: frames, states, digests and checkpoints on the way.
TEST_P(CrowdBits, DoNotDependOnBeingLookedAt) {
  const Scene scene = small_crowd(GetParam());
  for (const auto& engine : crowd_engines()) {
    const auto run = engine->start(scene, {});
    for (int k = 0; k < 12; ++k) {
      run->frame();
      dynamic_cast<RestartableRun&>(*run).checkpoint();
      run->digest();
      run->advance(5);
    }
    EXPECT_EQ(run->digest(), digest_after(*engine, scene, 60)) << engine->name();
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, CrowdBits, ::testing::Values(SumOrder::fast, SumOrder::canonical),
                         [](const auto& param) {
                           return param.param == SumOrder::fast ? "fast" : "canonical";
                         });

TEST(ZonedBits, AreThoseOfOneThreadAndOfTwoWithADigestThatStates) {
  for (const char* precision : {"single", "mixed", "double"}) {
    const std::string arguments = std::string(precision) + " zoned leapfrog_verlet 2 100";
    const Finished one = run_driver("POCL_MAX_PTHREAD_COUNT=1", arguments);
    const Finished two = run_driver("POCL_MAX_PTHREAD_COUNT=2", arguments);
    ASSERT_EQ(one.status, 0) << one.output;
    EXPECT_NE(one.output.find("digest"), std::string::npos);
    EXPECT_EQ(one.output, two.output) << precision;
  }
}

}  // namespace
}  // namespace grainproof::opencl::testing
