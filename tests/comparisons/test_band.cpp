// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "comparisons/band.hpp"
#include "comparisons/judge.hpp"
#include "tests/comparisons/rebounder.hpp"

namespace grainproof::test {
namespace {

// two samples of 1 … 5, whose variance is 2.5: standard error of the difference 1, 8 degrees of freedom,
// and the 99.95 % quantile of Student's t there is 5.0413 (tables).
TEST(Band, IsStudentsQuantileTimesTheStandardErrorOfTheDifference) {
  const std::array one{1.0, 2.0, 3.0, 4.0, 5.0};
  const std::array two{3.0, 4.0, 5.0, 6.0, 7.0};
  const BandDifference apart = band_difference(two, one);
  EXPECT_NEAR(apart.band, 5.0413, 5e-5);
  EXPECT_NEAR(apart.in_bands(), 2.0 / 5.0413, 1e-5);
}

// Welch: variances 1 and 0 over three each leave the two degrees of freedom of the first: t = 31.599.
TEST(Band, UnequalVariancesLeaveTheDegreesOfFreedomOfTheWiderSample) {
  const std::array wide{1.0, 2.0, 3.0};
  const std::array narrow{2.0, 2.0, 2.0};
  EXPECT_NEAR(band_difference(wide, narrow).band, 31.599 / std::sqrt(3.0), 1e-3);
}

TEST(Band, OfSingleRunsDoesNotExist) {
  const std::array one{1.0};
  EXPECT_TRUE(std::isnan(band_difference(one, one).in_bands()));
}

TEST(Band, OfRunsThatAllAgreeHasNoWidthAndStillTellsADifference) {
  const std::array one{1.0, 1.0};
  const std::array two{1.0 + 1e-15, 1.0 + 1e-15};
  EXPECT_EQ(band_difference(one, one).in_bands(), 0.0);
  EXPECT_GT(band_difference(one, two).in_bands(), 1e6);
}

/// Eight runs that differ in their approach, as seeds do.
Case seeded() {
  Case subject;
  subject.name = "seeded";
  for (int sample = 0; sample < 8; ++sample)
    subject.scenes.push_back({collision_with_fixed(16.0 + sample, 0.5), {"seconds", 0.0, sample, {}}});
  Expectation expectation;
  expectation.quantity = "restitution";
  expectation.against = "engine:other";
  expectation.statistic = Statistic::band;
  expectation.below = {{"", 1.0}};
  subject.expectations = {expectation};
  return subject;
}

TEST(Band, RowSaysBothMeansAndHoldsTheirDifferenceAgainstOneBand) {
  const Case subject = seeded();
  Rebounder other(0.1, 1.0);
  const auto verdict_of = [&](double size) {
    Rebounder engine(size, 1.0);
    return judge(subject, engine, [&](const std::string&) { return &other; }).at(0);
  };
  const Row same = verdict_of(0.1);
  EXPECT_EQ(same.verdict, Verdict::pass) << same.reason;
  EXPECT_EQ(same.error, 0.0);
  EXPECT_EQ(same.samples, 8);
  EXPECT_NE(same.reason.find("99.9 % band"), std::string::npos);
  const Row far = verdict_of(10.0);
  EXPECT_EQ(far.verdict, Verdict::fail);
  EXPECT_GT(far.error, 1.0);
  EXPECT_NE(far.reason.find("bands"), std::string::npos) << far.reason;
}

TEST(Band, OfSamplesOfWhichOneFailedIsNoNumber) {
  Case subject = seeded();
  subject.scenes[3].scene.title = "spoilt";
  Rebounder other(0.1, 1.0);
  Rebounder engine(0.2, 1.0);
  engine.spoil = [](const Scene& scene, Observations& seen) {
    if (scene.title == "spoilt")
      seen.outcome = {Outcome::Status::went_wrong, "out of the domain", 7, 0.1, {2}};
  };
  const Row row = judge(subject, engine, [&](const std::string&) { return &other; }).at(0);
  EXPECT_EQ(row.verdict, Verdict::fail);
  EXPECT_TRUE(std::isnan(row.error));
  EXPECT_NE(row.reason.find("sample 3"), std::string::npos) << row.reason;
}

TEST(Band, OfACurveIsImpossible) {
  Case subject = seeded();
  subject.expectations[0].quantity = "position";
  Rebounder other(0.1, 1.0);
  const Row row = judge(subject, other, [&](const std::string&) { return &other; }).at(0);
  EXPECT_EQ(row.verdict, Verdict::fail);
  EXPECT_NE(row.reason.find("no single number"), std::string::npos);
}

}  // namespace
}  // namespace grainproof::test
