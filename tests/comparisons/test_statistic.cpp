// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "comparisons/statistic.hpp"
#include "comparisons/tolerance.hpp"

namespace grainproof::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Statistics, AreWhatTheirNamesSay) {
  const std::array errors{3.0, -4.0, 0.0, 0.0};
  EXPECT_EQ(statistic_of(Statistic::maximum, errors), 4.0);
  EXPECT_EQ(statistic_of(Statistic::rms, errors), 2.5);
  EXPECT_EQ(statistic_of(Statistic::mean, errors), -0.25);
}

TEST(Statistics, OneNumberThatIsNoneSpoilsThemAll) {
  const std::array errors{3.0, nan, 0.0};
  for (const Statistic statistic : {Statistic::maximum, Statistic::rms, Statistic::mean})
    EXPECT_TRUE(std::isnan(statistic_of(statistic, errors)));
  EXPECT_TRUE(std::isnan(statistic_of(Statistic::maximum, {})));
}

TEST(Order, IsTheSlopeInLogarithms) {
  const std::array<std::pair<double, double>, 3> points{{{1.0, 7.0}, {0.5, -7.0 / 8.0}, {0.25, 7.0 / 64.0}}};
  EXPECT_NEAR(order_of_convergence(points), 3.0, 1e-14);
}

TEST(Tolerance, IsTheBoundPlusTheRoundOffFloor) {
  EXPECT_EQ(tolerance(1e-3, 0.0, 0x1p-24), 1e-3);
  EXPECT_EQ(tolerance(0.0, 32.0, 0x1p-24), 0x1p-19);
}

TEST(Tolerance, IsAboutSizesAndNaNNeverPasses) {
  EXPECT_TRUE(within(-1e-3, 1e-3));
  EXPECT_FALSE(within(-2e-3, 1e-3));
  EXPECT_FALSE(within(nan, 1e-3));
  EXPECT_FALSE(within(0.0, nan));
}

}  // namespace
}  // namespace grainproof::test
