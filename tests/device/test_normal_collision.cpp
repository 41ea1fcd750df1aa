// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "device_fixture.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

class NormalCollision : public ::testing::TestWithParam<Precision> {};

TEST_P(NormalCollision, PairLeavesWithRestitutionTimesSpeed) {
  const Observations seen = observed(options_for(GetParam()), head_on_scene(0.8, 256));
  const double rebound = seen.frames.back().velocity[1].x() / 2.0;
  // First order in the step: 7.2e-4 rms at 256 steps per contact, and at most three times that.
  EXPECT_LT(std::abs(rebound / 0.8 - 1.0), 3 * 7.2e-4);
  EXPECT_GT(std::abs(rebound / 0.8 - 1.0), 0.0);
}

// What is asked of it at contact/256, docs/precision.md.
TEST(MixedPrecision, AddsNoMoreThanEightUlpsOfTheImpactSpeed) {
  const Scene scene = head_on_scene(0.8, 256);
  const auto exact = observed(options_for(Precision::double_precision), scene);
  const auto seen = observed(options_for(Precision::mixed_precision), scene);
  const double apart = (seen.frames.back().velocity[1] - exact.frames.back().velocity[1]).norm();
  EXPECT_LE(apart, 8 * 2 * single_roundoff * 2.0);
  EXPECT_GT(apart, 0.0);
}

TEST(SinglePrecision, AddsNoMoreThanTheRoundOffOfTheImpactSpeed) {
  const Scene scene = head_on_scene(0.8, 256);
  const auto exact = observed(options_for(Precision::double_precision), scene);
  const auto seen = observed(options_for(Precision::single_precision), scene);
  const double apart = (seen.frames.back().velocity[1] - exact.frames.back().velocity[1]).norm();
  EXPECT_LE(apart, 32 * single_roundoff * 2.0);
}

TEST_P(NormalCollision, SettlesAtWeightOverStiffness) {
  const auto seen = observed(options_for(GetParam()), settling_scene(200));
  const double overlap = 0.05 - seen.frames.back().position[0].z();
  const double expected = sphere_mass(density, diameter) * 9.81 / stiffness;
  const double error = std::abs(overlap / expected - 1.0);
  RecordProperty("relative_error", ::testing::PrintToString(error));
  // Single: a few units of the force, whose parts are rounded. Double: the project's bar.
  EXPECT_LE(error, GetParam() == Precision::double_precision ? 1e-12 : 8 * single_roundoff);
}

GRAINPROOF_IN_EVERY_PRECISION(NormalCollision);

}  // namespace
}  // namespace grainproof::opencl::testing
