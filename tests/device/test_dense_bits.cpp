// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "crowds.hpp"
#include "device_fixture.hpp"
#include "driver_process.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

EngineOptions dense(double skin = 0.01, Precision precision = Precision::single_precision) {
  EngineOptions options = options_for(precision);
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

class DenseBits : public ::testing::TestWithParam<std::tuple<SumOrder, Precision>> {
 protected:
  Scene scene(double spread = 0.0) const { return bed(std::get<0>(GetParam()), spread); }
  EngineOptions options(double skin = 0.01) const { return dense(skin, std::get<1>(GetParam())); }
};

std::string name_of_order(const ::testing::TestParamInfo<std::tuple<SumOrder, Precision>>& param) {
  return std::string(std::get<0>(param.param) == SumOrder::fast ? "fast_" : "canonical_") +
         std::string(name_of(std::get<1>(param.param)));
}

TEST_P(DenseBits, DoNotChangeFromRunToRun) {
  EXPECT_EQ(ended(options(), scene(0.2)).digest, ended(options(), scene(0.2)).digest);
}

TEST_P(DenseBits, DoNotDependOnHowStepsAreAskedFor) {
  const Ended once = ended(options(0.002), scene());
  EXPECT_GT(once.rebuilds, 3);
  EXPECT_EQ(once.digest, ended(options(0.002), scene(), 15).digest);
}

TEST_P(DenseBits, DoNotDependOnLookingAtThem) {
  OpenClEngine engine(options());
  const auto watched = engine.start(scene(), {});
  for (int done = 0; done < crowd_steps; done += 50) {
    watched->advance(50);
    watched->frame();
    watched->state();
  }
  EXPECT_EQ(watched->digest(), ended(options(), scene()).digest);
}

INSTANTIATE_TEST_SUITE_P(Orders, DenseBits,
                         ::testing::Combine(::testing::Values(SumOrder::fast, SumOrder::canonical),
                                            ::testing::Values(Precision::single_precision,
                                                              Precision::double_precision)),
                         name_of_order);

EngineOptions by_one(EngineOptions options) {
  options.width = Width::one;
  return options;
}

// Other groups, another order within them and another search: only the physics is the same.
TEST(DenseBits, OfCanonicalOrderAreTheSameByOneAndByMany) {
  for (const auto& [precision, spread] :
       {std::pair(Precision::single_precision, 0.2), std::pair(Precision::double_precision, 0.0)}) {
    const Scene scene = bed(SumOrder::canonical, spread);
    const Ended many = ended(dense(0.004, precision), scene);
    const Ended one = ended(by_one(dense(0.004, precision)), scene);
    EXPECT_EQ(one.digest, many.digest);
    EXPECT_EQ(one.rebuilds, many.rebuilds);
  }
}

TEST(DenseBits, OfPredictedVelocitiesAreTheSameByOneAndByMany) {
  for (const double spread : {0.0, 0.2}) {
    Scene scene = bed(SumOrder::canonical, spread);
    scene.run.integrator = Integrator::velocity_verlet_predicted;
    EXPECT_EQ(ended(by_one(dense(0.004)), scene).digest, ended(dense(0.004), scene).digest);
  }
}

TEST(DenseBits, ByOneDoNotDependOnHowStepsAreAskedFor) {
  const Scene scene = bed(SumOrder::fast, 0.2);
  const Ended once = ended(by_one(dense(0.002)), scene);
  EXPECT_GT(once.rebuilds, 3);
  EXPECT_EQ(once.digest, ended(by_one(dense(0.002)), scene, 15).digest);
  EXPECT_NE(once.digest, ended(dense(0.002), scene).digest);
}

// So many bodies that the work-groups of a step are larger for one thread, and the last one is filled up.
TEST(DenseBits, DoNotDependOnTheNumberOfThreads) {
  for (const char* how : {"single dense", "double dense", "single dense_by_one"}) {
    const std::string arguments = how + std::string(" turning_liggghts 977 60");
    const Finished one = run_driver("POCL_MAX_PTHREAD_COUNT=1", arguments), all = run_driver("", arguments);
    ASSERT_EQ(one.status, 0) << one.output;
    EXPECT_NE(one.output.find("digest"), std::string::npos) << one.output;
    EXPECT_EQ(one.output, all.output);
  }
}

TEST(DenseBits, OfCanonicalOrderDoNotDependOnTheSkin) {
  for (const Precision precision : {Precision::single_precision, Precision::double_precision})
    for (const double spread : {0.0, 0.2}) {
      const Scene scene = bed(SumOrder::canonical, spread);
      const Ended usual = ended(dense(0.01, precision), scene), often = ended(dense(0.001, precision), scene);
      EXPECT_GT(often.rebuilds, 2 * usual.rebuilds);
      EXPECT_EQ(often.digest, usual.digest);
      EXPECT_EQ(ended(dense(0.025, precision), scene).digest, usual.digest);
    }
}

// A list a step: springs go from one to the next 150 times, and whoever touches must be near in all of them.
TEST(DenseBits, OfCanonicalOrderAreThoseOfASkinOfNextToNothing) {
  for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
    const Scene scene = bed(SumOrder::canonical);
    const Ended bare = ended(dense(1e-8 * diameter, precision), scene);
    EXPECT_GT(bare.rebuilds, crowd_steps - 5);
    EXPECT_EQ(bare.digest, ended(dense(0.01, precision), scene).digest);
  }
}

// docs/precision.md: single decides overlaps in double here.
TEST(DenseBits, OfMixedPrecisionAreThoseOfSingle) {
  for (const SumOrder order : {SumOrder::fast, SumOrder::canonical}) {
    const std::uint64_t single = ended(dense(), bed(order)).digest;
    EXPECT_EQ(ended(dense(0.01, Precision::mixed_precision), bed(order)).digest, single);
    EXPECT_NE(ended(dense(0.01, Precision::double_precision), bed(order)).digest, single);
  }
}

TEST(DenseBits, OfFastOrderDependOnTheSkin) {
  EXPECT_NE(ended(dense(0.001), bed(SumOrder::fast)).digest, ended(dense(0.03), bed(SumOrder::fast)).digest);
}

}  // namespace
}  // namespace grainproof::opencl::testing
