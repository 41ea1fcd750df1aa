// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "comparisons/judge.hpp"
#include "model/errors.hpp"
#include "tests/comparisons/rebounder.hpp"

namespace grainproof::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Case collisions() {
  Case subject;
  subject.name = "collision";
  for (const int steps : {8, 16, 32, 64})
    for (int sample = 0; sample < 4; ++sample) {
      const Scene scene = collision_with_fixed(steps, (sample + 0.5) / 4.0);
      subject.scenes.push_back(
          {scene, {"contact/" + std::to_string(steps), static_cast<double>(steps), sample, {}}});
    }
  Expectation expectation;
  expectation.quantity = "restitution";
  expectation.against = "value:0.8";
  expectation.statistic = Statistic::rms;
  subject.expectations = {expectation};
  return subject;
}

TEST(Judge, MeasuresTheOrderThatAnEngineHas) {
  for (const double order : {1.0, 2.0, 3.0}) {
    Case subject = collisions();
    subject.expectations[0].order = OrderBound{"contact/8", "contact/64", order, 1e-6};
    Rebounder engine(0.1, order);
    const std::vector<Row> rows = judge(subject, engine, {});
    ASSERT_EQ(rows.size(), 1u);
    ASSERT_TRUE(rows[0].order.has_value()) << rows[0].reason;
    EXPECT_NEAR(*rows[0].order, order, 1e-9);
    EXPECT_EQ(rows[0].verdict, Verdict::pass) << rows[0].reason;
    EXPECT_EQ(rows[0].points.size(), 4u);
    EXPECT_EQ(rows[0].step, "");
  }
}

TEST(Judge, FailsAnOrderThatIsNotTheOneClaimed) {
  Case subject = collisions();
  subject.expectations[0].order = OrderBound{"contact/8", "contact/64", 2.0, 0.1};
  Rebounder engine(0.1, 1.0);
  const std::vector<Row> rows = judge(subject, engine, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].verdict, Verdict::fail);
}

TEST(Judge, HoldsEachStepAgainstItsOwnBound) {
  Case subject = collisions();
  const double step = subject.scenes[0].scene.run.step;
  const double error = 0.1 * step / 0.01;
  subject.expectations[0].below = {{"contact/8", 1.001 * error}, {"contact/16", 0.499 * error}};
  Rebounder engine(0.1, 1.0);
  const std::vector<Row> rows = judge(subject, engine, {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].verdict, Verdict::pass) << rows[0].reason;
  EXPECT_NEAR(rows[0].error, error, 1e-12);
  EXPECT_EQ(rows[1].verdict, Verdict::fail);
  EXPECT_EQ(rows[1].samples, 4);
}

TEST(Judge, PointsAtTheRoundOffFloorAreLeftOutOfTheOrderAndNamed) {
  Case subject = collisions();
  subject.expectations[0].order = OrderBound{"contact/8", "contact/64", 3.0, 1e-6};
  const double smallest = 0.1 * std::pow(subject.scenes.back().scene.run.step / 0.01, 3.0);
  Rebounder engine(0.1, 3.0, 1.5 * smallest / 32.0);
  const Row row = judge(subject, engine, {}).at(0);
  EXPECT_EQ(row.verdict, Verdict::pass) << row.reason;
  EXPECT_EQ(row.points.size(), 3u);
  EXPECT_NE(row.reason.find("contact/64"), std::string::npos);
  Rebounder exact(0.0, 1.0);
  EXPECT_EQ(judge(subject, exact, {}).at(0).verdict, Verdict::fail);
}

TEST(Judge, OrderFailsWhereAStepOfItFails) {
  Case subject = collisions();
  subject.expectations[0].order = OrderBound{"contact/8", "contact/64", 1.0, 0.5};
  Rebounder engine(0.1, 1.0);
  engine.spoil = [](const Scene& scene, Observations& seen) {
    if (scene.run.step < 2e-4) seen.frames.back().velocity[1].y() = nan;
  };
  const Row row = judge(subject, engine, {}).at(0);
  EXPECT_EQ(row.verdict, Verdict::fail);
  EXPECT_NE(row.reason.find("contact/64, sample 0"), std::string::npos) << row.reason;
}

TEST(Judge, ToleranceHasTheRoundOffFloorOfTheEngine) {
  Case subject = collisions();
  subject.expectations[0].below = {{"", 0.0}};
  Rebounder single(0.0, 1.0, 0x1p-24);
  const std::vector<Row> rows = judge(subject, single, {});
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].tolerance, 32 * 0x1p-24);
  EXPECT_EQ(rows[0].verdict, Verdict::pass);
  EXPECT_EQ(rows[0].precision, "double");
}

/// The reason of a failing row; anything else is a failure of the test.
std::string why_failing(Rebounder& engine) {
  Case subject = collisions();
  subject.expectations[0].below = {{"contact/8", 1e9}};
  const std::vector<Row> rows = judge(subject, engine, {});
  EXPECT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows.at(0).verdict, Verdict::fail);
  return rows.at(0).reason;
}

TEST(Judge, AnythingNotFiniteFailsHoweverWideTheBound) {
  Rebounder engine(0.1, 1.0);
  engine.spoil = [](const Scene&, Observations& seen) { seen.frames.back().velocity[1].x() = nan; };
  EXPECT_NE(why_failing(engine).find("not finite"), std::string::npos);
  engine.spoil = [](const Scene&, Observations& seen) { seen.frames[0].position[0].z() = HUGE_VAL; };
  EXPECT_NE(why_failing(engine).find("particle 1"), std::string::npos);
}

TEST(Judge, RunsThatWentWrongOrStopEarlyFailWithTheReason) {
  Rebounder engine(0.1, 1.0);
  engine.spoil = [](const Scene&, Observations& seen) {
    seen.outcome = {Outcome::Status::went_wrong, "overlap too deep", 7, 0.5, {1}};
  };
  EXPECT_NE(why_failing(engine).find("step 7, 0.5 s: overlap too deep"), std::string::npos);
  engine.spoil = [](const Scene&, Observations& seen) { seen.frames.pop_back(); };
  EXPECT_NE(why_failing(engine).find("before the end"), std::string::npos);
  engine.spoil = [](const Scene&, Observations& seen) { seen.frames[0].velocity.pop_back(); };
  EXPECT_NE(why_failing(engine).find("missing"), std::string::npos);
  engine.spoil = [](const Scene&, Observations&) { throw EngineFailed("the device is gone"); };
  EXPECT_NE(why_failing(engine).find("the device is gone"), std::string::npos);
}

TEST(Judge, SignIsThatOfTheMeanError) {
  Case subject = collisions();
  subject.expectations[0].sign = 1;
  Rebounder above(0.1, 1.0);
  Rebounder below(-0.1, 1.0);
  for (const Row& row : judge(subject, above, {})) EXPECT_EQ(row.verdict, Verdict::pass) << row.reason;
  const std::vector<Row> rows = judge(subject, below, {});
  ASSERT_EQ(rows.size(), 4u);
  for (const Row& row : rows) EXPECT_EQ(row.verdict, Verdict::fail);
}

TEST(Judge, SweptKeysOtherThanTheStepHaveRowsOfTheirOwn) {
  Case subject = collisions();
  for (std::size_t i = 0; i < subject.scenes.size(); ++i) {
    const bool shifted = i % 2 == 0;
    subject.scenes[i].point.values = {{"offset", shifted ? "1" : "0"}};
    subject.scenes[i].scene.run.integrator =
        shifted ? Integrator::leapfrog_verlet : Integrator::velocity_verlet;
  }
  subject.expectations[0].below = {{"contact/8", 1.0}};
  Rebounder engine(0.1, 1.0);
  const std::vector<Row> rows = judge(subject, engine, {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].values.at("offset"), "1");
  EXPECT_EQ(rows[0].integrator, "leapfrog_verlet");
  subject.expectations[0].where = {{"offset", "0"}, {"integrator", "velocity_verlet"}};
  EXPECT_EQ(judge(subject, engine, {}).size(), 1u);
  subject.expectations[0].where = {{"offset", "2"}};
  EXPECT_EQ(judge(subject, engine, {}).at(0).verdict, Verdict::fail);
}

TEST(Judge, WhatAnEngineDoesNotSupportIsOneRowWithTheReason) {
  Case subject = collisions();
  subject.expectations[0].quantity = "momentum";
  subject.expectations[0].against = "invariant:momentum";
  subject.expectations[0].below = {{"", 1.0}};
  Rebounder engine(0.1, 1.0);
  const std::vector<Row> rows = judge(subject, engine, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].verdict, Verdict::unsupported);
  EXPECT_EQ(rows[0].reason, "keeps no ledger");
  EXPECT_EQ(rows[0].quantity, "momentum");
}

TEST(Judge, ClaimsAreForTheEnginesThatTheyName) {
  Case subject = collisions();
  subject.expectations[0].below = {{"contact/8", 1.0}};
  subject.expectations[0].engines = {"opencl"};
  Rebounder engine(0.1, 1.0);
  EXPECT_TRUE(judge(subject, engine, {}).empty());
  engine.called = "opencl:single";
  EXPECT_EQ(judge(subject, engine, {}).size(), 1u);
}

TEST(Judge, NamesOfNothingFailByThemselves) {
  Rebounder engine(0.1, 1.0);
  Case subject = collisions();
  subject.expectations[0].quantity = "colour";
  EXPECT_EQ(judge(subject, engine, {}).at(0).verdict, Verdict::fail);
  subject.expectations[0].quantity = "restitution";
  subject.expectations[0].against = "closed_form:nobody";
  EXPECT_EQ(judge(subject, engine, [](const std::string&) { return nullptr; }).at(0).verdict, Verdict::fail);
  subject.expectations[0].against = "engine:nobody";
  EXPECT_EQ(judge(subject, engine, [](const std::string&) { return nullptr; }).at(0).verdict,
            Verdict::unsupported);
}

TEST(Judge, AnotherEngineIsRunOnceForAllThatAreHeldAgainstIt) {
  Case subject = collisions();
  subject.expectations[0].against = "engine:other";
  subject.expectations[0].below = {{"", 0.0}};
  Rebounder other(0.1, 1.0, 0x1p-53);
  other.called = "other";
  Judge all(subject,
            [&](const std::string& against) { return against == "engine:other" ? &other : nullptr; });
  Rebounder first(0.1, 1.0, 0x1p-24);
  for (const Row& row : all.rows(first)) {
    EXPECT_EQ(row.verdict, Verdict::pass) << row.reason;
    EXPECT_EQ(row.tolerance, 32 * (0x1p-24 + 0x1p-53));
  }
  EXPECT_EQ(other.observed, 16);
  Rebounder second(0.2, 1.0);
  for (const Row& row : all.rows(second)) EXPECT_EQ(row.verdict, Verdict::fail);
  EXPECT_EQ(other.observed, 16);
  EXPECT_EQ(first.observed, 16);
  EXPECT_TRUE(all.rows(other).empty());  // itself
}

TEST(Judge, RefusalIsJudgedByItsMessage) {
  Case subject;
  subject.refused = "scene.toml:3:1: found a negative density; expected a positive one";
  Rebounder engine(0.1, 1.0);
  ASSERT_EQ(judge(subject, engine, {}).size(), 1u);
  EXPECT_EQ(judge(subject, engine, {})[0].verdict, Verdict::fail);
  Expectation says;
  says.outcome = "refused";
  says.reason = "negative density";
  subject.expectations = {says};
  ASSERT_EQ(judge(subject, engine, {}).size(), 1u);
  EXPECT_EQ(judge(subject, engine, {})[0].verdict, Verdict::pass);
  subject.expectations[0].reason = "negative mass";
  EXPECT_EQ(judge(subject, engine, {})[0].verdict, Verdict::fail);
  subject.refused.clear();
  EXPECT_EQ(judge(subject, engine, {})[0].verdict, Verdict::fail);
}

TEST(Judge, ExpectedFailureOfARunIsOneRowJudgedByItsReason) {
  Case subject = collisions();
  subject.expectations[0].outcome = "went_wrong";
  subject.expectations[0].reason = "too deep";
  Rebounder engine(0.1, 1.0);
  ASSERT_EQ(judge(subject, engine, {}).size(), 1u);
  EXPECT_EQ(judge(subject, engine, {})[0].verdict, Verdict::fail);
  engine.spoil = [](const Scene&, Observations& seen) {
    seen.outcome = {Outcome::Status::went_wrong, "overlap too deep", 7, 0.5, {1}};
  };
  EXPECT_EQ(judge(subject, engine, {})[0].verdict, Verdict::pass);
  subject.expectations[0].reason = "escaped";
  EXPECT_EQ(judge(subject, engine, {})[0].verdict, Verdict::fail);
}

}  // namespace
}  // namespace grainproof::test
