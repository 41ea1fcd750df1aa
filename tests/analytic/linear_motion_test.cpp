// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/linear_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace grainproof::analytic {
namespace {

/// Every kind of root of the auxiliary equation.
const LinearMotion::Equation equations[] = {
    {2.0, 18.0, 0.0, 1.0},   {2.0, 18.0, 3.0, 1.0}, {2.0, 18.0, 12.0, 1.0}, {2.0, 18.0, 12.0000001, 1.0},
    {2.0, 18.0, 400.0, 1.0}, {2.0, 0.0, 3.0, 1.0},  {2.0, 0.0, 0.0, 1.0},   {2.0, -18.0, 3.0, 1.0},
};

TEST(LinearMotion, ObeysItsEquation) {
  for (const auto& e : equations) {
    const LinearMotion motion(e, {0.3, -1.7});
    const double rate = std::max({1.0, e.damping / e.mass, std::sqrt(std::abs(e.stiffness) / e.mass)});
    const double h = 1e-3 / rate;
    for (double t : {0.01, 0.3, 1.0}) {
      const auto derivative = [&](auto value) {
        return (value(t - 2 * h) - 8 * value(t - h) + 8 * value(t + h) - value(t + 2 * h)) / (12 * h);
      };
      const double v = derivative([&](double s) { return motion.at(s).position; });
      const double a = derivative([&](double s) { return motion.at(s).velocity; });
      const Motion now = motion.at(t);
      // (1e-3)⁴ of the rate of change, and 1e-16 of the values over h.
      EXPECT_NEAR(v, now.velocity, 2e-11 * rate) << e.stiffness << ' ' << e.damping;
      EXPECT_NEAR(e.mass * a, e.force - e.damping * now.velocity - e.stiffness * now.position,
                  2e-10 * rate * e.mass)
          << e.stiffness << ' ' << e.damping;
    }
  }
}

TEST(LinearMotion, StartsWhereItIsToldTo) {
  for (const auto& e : equations) {
    EXPECT_NEAR(LinearMotion(e, {0.3, -1.7}).at(0.0).position, 0.3, 1e-16);
    EXPECT_EQ(LinearMotion(e, {0.3, -1.7}).at(0.0).velocity, -1.7);
  }
}

TEST(LinearMotion, TurnsWhereItsVelocityIsZero) {
  int turning = 0;
  for (const auto& e : equations) {
    const LinearMotion motion(e, {0.3, -0.2});
    if (const auto turn = motion.turning_time()) {
      ++turning;
      EXPECT_NEAR(motion.at(*turn).velocity, 0.0, 1e-15) << e.stiffness << ' ' << e.damping;
      for (int n = 1; n < 100; ++n) EXPECT_LT(motion.at(*turn * n / 100).velocity * -0.2, 1.0);
    }
  }
  EXPECT_GE(turning, 3);
}

TEST(LinearMotion, FirstPassageIsTheFirst) {
  const LinearMotion swing({1.0, 1.0, 0.0, 0.0}, {1.0, 0.0});
  EXPECT_NEAR(swing.first_time_at(0.0).value(), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(swing.first_time_at(-0.5).value(), 2 * std::numbers::pi / 3, 1e-15);
  EXPECT_FALSE(swing.first_time_at(1.5));
  const LinearMotion late({1.0, 1.0, 0.0, 0.0}, {0.0, -1.0});
  EXPECT_NEAR(late.first_time_at(0.5).value(), 7 * std::numbers::pi / 6, 1e-15);
  EXPECT_NEAR(late.first_time_at(0.0).value(), std::numbers::pi, 1e-15);
}

TEST(LinearMotion, AnOverDampedReturnNeverArrives) {
  const LinearMotion slow({1.0, 1.0, 5.0, 0.0}, {0.0, -1.0});
  EXPECT_FALSE(slow.first_time_at(0.0));
  EXPECT_TRUE(slow.first_time_at(-0.1));
}

TEST(LinearMotion, AFallFindsTheFloorOnce) {
  const LinearMotion fall({1.0, 0.0, 0.0, -9.81}, {0.5, 0.0});
  EXPECT_NEAR(fall.first_time_at(0.0).value(), std::sqrt(1.0 / 9.81), 1e-16);
  EXPECT_FALSE(fall.first_time_at(0.6));
  const LinearMotion thrown({1.0, 0.0, 0.0, -9.81}, {0.0, 3.0});
  EXPECT_NEAR(thrown.first_time_at(0.0).value(), 6.0 / 9.81, 1e-15);
}

}  // namespace
}  // namespace grainproof::analytic
