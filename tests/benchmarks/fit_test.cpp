// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "app/bench_fit.hpp"
#include "app/bench_sample.hpp"

namespace grainproof::app {
namespace {

/// t = intercept + factor N^exponent, off by `noise` up and down in turn.
std::vector<Timed> points(double intercept, double factor, double exponent, double noise = 0.0) {
  std::vector<Timed> found;
  double sign = 1.0;
  for (double particles = 1e4; particles < 2e7; particles *= 2.0) {
    const double exact = intercept + factor * std::pow(particles, exponent);
    found.push_back({particles, exact * (1.0 + sign * noise)});
    sign = -sign;
  }
  return found;
}

TEST(PowerLaw, FindsTheExponentBesideAnIntercept) {
  const auto law = fit_power_law(points(0.02, 3e-8, 1.07));
  ASSERT_TRUE(law);
  // golden section ends at 1e-7
  EXPECT_NEAR(law->exponent, 1.07, 1e-6);
  EXPECT_NEAR(law->intercept, 0.02, 1e-6);
}

TEST(PowerLaw, HasNoNegativeIntercept) {
  std::vector<Timed> found = points(0.0, 1e-7, 1.0);
  found.front().seconds *= 0.5;
  EXPECT_EQ(fit_power_law(found)->intercept, 0.0);
}

TEST(PowerLaw, ConfidenceHoldsTheTruthAndGrowsWithTheNoise) {
  const auto quiet = fit_power_law(points(0.01, 1e-7, 1.0, 0.01));
  const auto loud = fit_power_law(points(0.01, 1e-7, 1.0, 0.1));
  EXPECT_LT(quiet->exponent_low, 1.0);
  EXPECT_GT(quiet->exponent_high, 1.0);
  EXPECT_GT(loud->exponent_high - loud->exponent_low, 5.0 * (quiet->exponent_high - quiet->exponent_low));
}

TEST(PowerLaw, OfLargeSizesAloneIsNarrowerWithAKnownIntercept) {
  std::vector<Timed> large = points(0.02, 3e-8, 1.07, 0.02);
  large.erase(large.begin(), large.end() - 5);
  const auto free = fit_power_law(large), held = fit_power_law(large, 0.02);
  EXPECT_EQ(held->intercept, 0.02);
  EXPECT_LT(held->exponent_low, 1.07);
  EXPECT_GT(held->exponent_high, 1.07);
  EXPECT_LT(held->exponent_high - held->exponent_low, 0.5 * (free->exponent_high - free->exponent_low));
}

TEST(PowerLaw, NeedsFourSizes) {
  std::vector<Timed> found = points(0.0, 1e-7, 1.0);
  found.resize(3);
  EXPECT_FALSE(fit_power_law(found));
}

nlohmann::json report(const std::vector<std::pair<std::string, double>>& measured) {
  nlohmann::json benchmarks = nlohmann::json::array();
  for (const auto& [name, speed] : measured)
    benchmarks.push_back({{"name", name}, {"threads", 1}, {"real_time", 1.0}, {"cundall_number", speed}});
  return {{"benchmarks", benchmarks}};
}

TEST(Samples, BecomeOneRowASubjectWithMedianAndRange) {
  const auto rows =
      rows_of(samples_of(report({{"peers/scene:bed_1k/engine:a/round:0/iterations:1/manual_time", 3.0},
                                 {"peers/scene:bed_1k/engine:a/round:1/iterations:1/manual_time", 1.0},
                                 {"peers/scene:bed_1k/engine:a/round:2/iterations:1/manual_time", 2.0},
                                 {"peers/scene:bed_1k/engine:b/round:0/iterations:1/manual_time", 7.0}})));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("suite"), "peers");
  EXPECT_EQ(rows[0].at("scene"), "bed_1k");
  EXPECT_EQ(rows[0].at("cundall_number"), 2.0);
  EXPECT_EQ(rows[0].at("cundall_min"), 1.0);
  EXPECT_EQ(rows[0].at("cundall_max"), 3.0);
  EXPECT_EQ(rows[0].at("rounds"), 3);
  EXPECT_FALSE(rows[0].contains("real_time"));
}

TEST(Samples, AreComparedRoundByRound) {
  const auto samples = samples_of(report({{"peers/engine:a/round:0", 6.0},
                                          {"peers/engine:b/round:0", 2.0},
                                          {"peers/engine:a/round:1", 10.0},
                                          {"peers/engine:b/round:1", 5.0},
                                          {"peers/engine:a/round:2", 10.0}}));
  EXPECT_EQ(ratios(samples, samples[0].subject(), samples[1].subject(), "cundall_number"),
            (std::vector<double>{3.0, 2.0}));
}

TEST(Samples, ThatFailedSayWhy) {
  nlohmann::json failed = report({{"peers/engine:a/round:0", 0.0}});
  failed["benchmarks"][0]["error_occurred"] = true;
  failed["benchmarks"][0]["error_message"] = "not installed";
  const auto rows = rows_of(samples_of(failed));
  EXPECT_EQ(rows[0].at("status"), "not installed");
  EXPECT_FALSE(rows[0].contains("cundall_number"));
}

}  // namespace
}  // namespace grainproof::app
