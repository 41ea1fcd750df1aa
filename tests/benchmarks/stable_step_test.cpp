// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/stable_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "benchmarks/common/stability_cases.hpp"
#include "reference_cpu/reference_engine.hpp"

namespace grainproof::bench {
namespace {

constexpr std::int64_t most_steps = 50000;

/// Of a damped pair, run by velocity Verlet whatever the prediction is of.
MeasuredLimit limit_of_a_pair(const std::string& predicted_for, double& predicted) {
  Scene scene = resting_scene({"pair", "0.5"});
  scene.run.integrator = Integrator::velocity_verlet;
  reference::ReferenceEngine engine;
  const Prediction prediction(scene, predicted_for);
  predicted = prediction.limit();
  return measured_limit(engine, scene, prediction, most_steps);
}

TEST(StableStep, TakesTwoRunsWhereThePredictionIsRight) {
  double predicted = 0.0;
  const MeasuredLimit limit = limit_of_a_pair("velocity_verlet", predicted);
  EXPECT_EQ(limit.runs, 2);
  EXPECT_LT(limit.stable, predicted);
  EXPECT_GT(limit.unstable, predicted);
  EXPECT_NEAR(limit.farthest_from(predicted), 0.005, 1e-4) << "it knows no better than that";
}

TEST(StableStep, IsFoundWhereThePredictionIsWrong) {
  double right = 0.0, wrong = 0.0;
  limit_of_a_pair("velocity_verlet", right);
  for (const char* other : {"velocity_verlet_predicted", "velocity_verlet_implicit"}) {
    const MeasuredLimit limit = limit_of_a_pair(other, wrong);
    ASSERT_GT(std::abs(wrong / right - 1.0), 0.05) << "they must differ to tell anything";
    EXPECT_NEAR(limit.step(), right, 0.005 * right) << other;
    EXPECT_LT(limit.unstable - limit.stable, 0.0026 * right) << other;
    EXPECT_GT(limit.farthest_from(wrong), 0.05) << other;
  }
}

}  // namespace
}  // namespace grainproof::bench
