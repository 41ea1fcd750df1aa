// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/long_run.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "benchmarks/common/long_verdicts.hpp"
#include "comparisons/peers/process.hpp"
#include "reference_cpu/reference_engine.hpp"

namespace grainproof::bench {
namespace {

constexpr double u = 0x1p-53;

LongPlan short_plan(Integrator integrator = Integrator::velocity_verlet) {
  LongPlan plan = long_plan("bounces", integrator, true);
  plan.steps /= 10;
  plan.windows = 20;
  return plan;
}

bool go_on(std::int64_t) {
  return true;
}

TEST(LongRun, SeesTheSameWhereItWasStoppedAndStartedAgain) {
  const LongPlan plan = short_plan();
  reference::ReferenceEngine engine;
  const TemporaryFolder whole, stopped;
  const LongHistory expected = long_run(engine, plan, {whole.path(), "one"}, go_on);
  int windows = 0;
  const LongPlace place{stopped.path(), "one"};
  EXPECT_FALSE(long_run(engine, plan, place, [&](std::int64_t) { return ++windows < 7; }).complete);
  int more = 0;
  const LongHistory found = long_run(engine, plan, place, [&](std::int64_t) { return ++more > 0; });
  EXPECT_EQ(more, 13) << "it did not go on from where it was stopped";
  ASSERT_EQ(found.windows.size(), expected.windows.size());
  for (std::size_t i = 0; i < found.windows.size(); ++i) {
    EXPECT_EQ(found.windows[i].step, expected.windows[i].step);
    EXPECT_EQ(found.windows[i].mean, expected.windows[i].mean);
    EXPECT_EQ(found.windows[i].most, expected.windows[i].most);
  }
}

TEST(LongRun, StartsAnewAfterAnotherProgramOrADamagedCheckpoint) {
  const LongPlan plan = short_plan();
  reference::ReferenceEngine engine;
  const TemporaryFolder folder;
  const auto stop_at = [&](const std::string& stamp, int most) {
    int windows = 0;
    long_run(engine, plan, {folder.path(), stamp}, [&](std::int64_t) { return ++windows < most; });
    return windows;
  };
  stop_at("one", 7);
  EXPECT_EQ(stop_at("other", 9), 9) << "what another program had seen was believed";
  std::ofstream(folder.path() / "checkpoint.h5") << "damaged";
  EXPECT_EQ(stop_at("other", 25), 20) << "a damaged checkpoint was believed";
}

TEST(LongVerdicts, ArePassedByTheDefaultAndFailADriftAndALoss) {
  const LongPlan plan = short_plan();
  reference::ReferenceEngine engine;
  const TemporaryFolder folder;
  LongHistory history = long_run(engine, plan, {folder.path(), "one"}, go_on);
  for (const std::string& quantity : long_quantities("bounces", Integrator::velocity_verlet))
    EXPECT_TRUE(long_verdict(plan, history, quantity, u).held) << quantity;
  at(history.windows.back().most, Look::energy) *= 1.1;
  at(history.windows.back().most, Look::momentum) = 1e-9;
  at(history.windows.back().most, Look::position) = 1e-6;
  at(history.windows.back().most, Look::overlap) *= 1.1;
  for (const std::string& quantity : long_quantities("bounces", Integrator::velocity_verlet))
    EXPECT_FALSE(long_verdict(plan, history, quantity, u).held) << quantity;
}

TEST(LongVerdicts, TellTheStepAtWhichTheSourcesSchemeLosesAnUndampedPair) {
  const LongPlan plan = short_plan(Integrator::euler_trapezoid);
  reference::ReferenceEngine engine;
  const TemporaryFolder folder;
  LongHistory history = long_run(engine, plan, {folder.path(), "one"}, go_on);
  EXPECT_TRUE(long_verdict(plan, history, "end", u).held);
  history.failed.clear();
  EXPECT_FALSE(long_verdict(plan, history, "end", u).held) << "it must be lost";
}

}  // namespace
}  // namespace grainproof::bench
