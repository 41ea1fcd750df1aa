// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "app/bench_work_precision.hpp"

namespace grainproof::app {
namespace {

Sample point(const std::string& engine, double steps, double error, double seconds, int round = 0) {
  Sample sample;
  sample.keys = {{"suite", "accuracy"},       {"scene", "pair_gas"},
                 {"engine", engine},          {"precision", "double"},
                 {"integrator", "leap-frog"}, {"steps_per_contact", std::to_string(static_cast<int>(steps))}};
  sample.values = {{"error", error}, {"wall_s", seconds}};
  sample.round = round;
  return sample;
}

TEST(TimeToError, OfAPowerLawIsThatLaws) {
  // error 0.2/N, time N/100: 1e-3 at 200 steps, in 2 s.
  std::vector<WorkPoint> curve;
  for (double steps : {256.0, 8.0, 64.0}) curve.push_back({0.2 / steps, steps / 100.0, steps});
  const auto reached = interpolated_at(curve, 1e-3);
  ASSERT_TRUE(reached);
  EXPECT_NEAR(reached->steps_per_contact, 200.0, 1e-9);
  EXPECT_NEAR(reached->wall_s, 2.0, 1e-11);
}

TEST(TimeToError, IsThatOfTheCoarsestPointWhereItSuffices) {
  EXPECT_EQ(interpolated_at({{1e-4, 0.5, 8.0}, {1e-5, 1.0, 16.0}}, 1e-3)->wall_s, 0.5);
}

TEST(TimeToError, IsNothingWhereNoPointIsAccurateEnough) {
  EXPECT_FALSE(interpolated_at({{1e-1, 0.5, 8.0}, {1e-2, 1.0, 16.0}}, 1e-3));
  const auto rows = times_to_error({point("reference", 8, 1e-1, 0.5)}, 1e-3);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_TRUE(rows[0].at("wall_s").is_null());
}

TEST(TimeToError, RatiosAreTakenRoundByRound) {
  std::vector<Sample> samples;
  for (int round : {0, 1, 2}) {
    const double slow = 1.0 + round;  // the machine slows down for everyone
    samples.push_back(point("lammps", 8, 1e-3, 6.0 * slow, round));
    samples.push_back(point("reference", 8, 1e-3, 2.0 * slow, round));
  }
  const auto ratios = ratios_to_error(samples, 1e-3);
  ASSERT_EQ(ratios.size(), 1u);
  EXPECT_DOUBLE_EQ(ratios[0].at("min").get<double>(), 3.0);
  EXPECT_DOUBLE_EQ(ratios[0].at("max").get<double>(), 3.0);
}

TEST(WorkPrecision, PointsThatFailedAreListed) {
  std::vector<Sample> samples{point("reference", 8, 1e-1, 0.5), point("reference", 16, 0.0, 0.0)};
  samples[1].error = "unstable: …";
  const auto failed = failed_points(rows_of(samples));
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_EQ(failed[0].at("steps_per_contact"), 16);
}

TEST(WorkPrecision, EachPointHasTheOrderFromTheNextCoarser) {
  auto rows = rows_of({point("reference", 8, 1e-1, 0.5), point("reference", 32, 1e-1 / 16.0, 0.5)});
  add_local_orders(rows);
  EXPECT_FALSE(rows[0].contains("order"));
  EXPECT_NEAR(rows[1].at("order").get<double>(), 2.0, 1e-12);
}

}  // namespace
}  // namespace grainproof::app
