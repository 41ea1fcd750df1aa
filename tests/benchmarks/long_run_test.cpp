// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/long_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

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

/// Overlaps of 125 windows about 1, each 0.8 of what the one before was off by, and `shift` more in the second half.
LongHistory remembering_bed(std::uint64_t seed, double shift) {
  constexpr double kept = 0.8, scatter = 0.05;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> chance(0.0, scatter * std::sqrt(1.0 - kept * kept));
  LongHistory history;
  double off = 0.0;
  for (std::int64_t i = 0; i < 125; ++i) {
    off = kept * off + chance(random);
    Window window{i, {}, {}};
    at(window.mean, Look::overlap) = 1.0 + off + (i > 75 ? shift : 0.0);
    history.windows.push_back(window);
  }
  return history;
}

int found_alike(double shift) {
  LongPlan plan = short_plan();
  plan.name = "vibrated";
  int alike = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    alike += long_verdict(plan, remembering_bed(seed, shift), "overlap", u).held;
  return alike;
}

TEST(LongVerdicts, TellABedThatRemembersFromOneThatDrifts) {
  EXPECT_GE(found_alike(0.0), 198);
  EXPECT_LE(found_alike(0.3), 2);
}

}  // namespace
}  // namespace grainproof::bench
