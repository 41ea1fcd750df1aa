// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "crowds.hpp"
#include "device_fixture.hpp"
#include "driver_process.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

EngineOptions dense(double skin = 0.01) {
  EngineOptions options = options_for(Precision::single_precision);
  options.path = Path::dense;
  options.skin = skin;
  return options;
}

Scene bed(SumOrder order, double spread = 0.0) {
  Scene scene = crowded_scene({.spread = spread});
  scene.run.order = order;
  return scene;
}

struct Ended {
  std::uint64_t digest;
  std::int64_t rebuilds;
};

Ended ended(const EngineOptions& options, const Scene& scene, int at_once = crowd_steps) {
  OpenClEngine engine(options);
  const auto run = engine.start(scene, {});
  for (int done = 0; done < crowd_steps; done += at_once) {
    run->advance(at_once);
    run->synchronise();
  }
  return {run->digest(), run->counters().list_rebuilds};
}

class DenseBits : public ::testing::TestWithParam<SumOrder> {};

TEST_P(DenseBits, DoNotChangeFromRunToRun) {
  const Scene scene = bed(GetParam(), 0.2);
  EXPECT_EQ(ended(dense(), scene).digest, ended(dense(), scene).digest);
}

TEST_P(DenseBits, DoNotDependOnHowStepsAreAskedFor) {
  const Ended once = ended(dense(0.002), bed(GetParam()));
  EXPECT_GT(once.rebuilds, 3);
  EXPECT_EQ(once.digest, ended(dense(0.002), bed(GetParam()), 15).digest);
}

TEST_P(DenseBits, DoNotDependOnLookingAtThem) {
  OpenClEngine engine(dense());
  const auto watched = engine.start(bed(GetParam()), {});
  for (int done = 0; done < crowd_steps; done += 50) {
    watched->advance(50);
    watched->frame();
    watched->state();
  }
  EXPECT_EQ(watched->digest(), ended(dense(), bed(GetParam())).digest);
}

INSTANTIATE_TEST_SUITE_P(Orders, DenseBits, ::testing::Values(SumOrder::fast, SumOrder::canonical),
                         [](const ::testing::TestParamInfo<SumOrder>& param) {
                           return param.param == SumOrder::fast ? "fast" : "canonical";
                         });

TEST(DenseBits, DoNotDependOnTheNumberOfThreads) {
  const std::string arguments = "single dense turning_liggghts 60 100";
  const Finished one = run_driver("POCL_MAX_PTHREAD_COUNT=1", arguments), all = run_driver("", arguments);
  ASSERT_EQ(one.status, 0) << one.output;
  EXPECT_NE(one.output.find("digest"), std::string::npos) << one.output;
  EXPECT_EQ(one.output, all.output);
}

TEST(DenseBits, OfCanonicalOrderDoNotDependOnTheSkin) {
  for (const double spread : {0.0, 0.2}) {
    const Scene scene = bed(SumOrder::canonical, spread);
    const Ended usual = ended(dense(0.01), scene), often = ended(dense(0.001), scene);
    EXPECT_GT(often.rebuilds, 2 * usual.rebuilds);
    EXPECT_EQ(often.digest, usual.digest);
    EXPECT_EQ(ended(dense(0.025), scene).digest, usual.digest);
  }
}

TEST(DenseBits, OfFastOrderDependOnTheSkin) {
  EXPECT_NE(ended(dense(0.001), bed(SumOrder::fast)).digest, ended(dense(0.03), bed(SumOrder::fast)).digest);
}

Outcome outcome_of(Path path, Scene scene) {
  EngineOptions options = dense();
  options.path = path;
  OpenClEngine engine(options);
  return engine.observe(scene, {}).outcome;
}

void expect_same_failure(const Scene& scene, const std::string& words) {
  const Outcome zoned = outcome_of(Path::zoned, scene), seen = outcome_of(Path::dense, scene);
  EXPECT_EQ(seen.status, Outcome::Status::went_wrong);
  EXPECT_NE(seen.reason.find(words), std::string::npos) << seen.reason;
  EXPECT_EQ(seen.reason, zoned.reason);
  EXPECT_EQ(seen.step, zoned.step);
  EXPECT_EQ(seen.particles, zoned.particles);
}

TEST(DenseFailures, AnEscapeIsToldAsByTheZonedPath) {
  Scene scene = bed(SumOrder::fast);
  scene.walls.clear();
  scene.domain.boundary[2] = Boundary::open;
  scene.particles.back().velocity = {0, 0, 80.0};
  expect_same_failure(scene, "left the domain through the upper z face");
}

TEST(DenseFailures, TooDeepAnOverlapIsToldAsByTheZonedPath) {
  Scene scene = bed(SumOrder::fast);
  scene.run.overlap_limit = 0.1;
  scene.particles[444].velocity = {30.0, 0, 0};
  expect_same_failure(scene, "overlaps particle");
}

TEST(DenseFailures, AWallTooDeepIsToldAsByTheZonedPath) {
  Scene scene = bed(SumOrder::fast);
  scene.run.overlap_limit = 0.1;
  scene.particles[4].velocity = {0, 0, -30.0};
  expect_same_failure(scene, "overlaps wall lower");
}

}  // namespace
}  // namespace grainproof::opencl::testing
