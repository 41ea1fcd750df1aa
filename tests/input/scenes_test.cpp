// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "input/read_case.hpp"

namespace grainproof {
namespace {

TEST(Scenes, NormalCollisionExpandsToEveryStepPhaseAndIntegrator) {
  const Case read = read_case("scenes/normal_collision.toml");
  EXPECT_EQ(read.scenes.size(), 8u * 256u * 3u);
}

TEST(Scenes, SettlingStepIsASixtyFourthOfTheContact) {
  const Case read = read_case("scenes/settling.toml");
  ASSERT_EQ(read.scenes.size(), 3u);
  // t_c = π/sqrt(k/m − (η/2m)²) for m = 1.0471976 kg, k = 1e5 N/m, ε = 0.8, by hand.
  EXPECT_NEAR(read.scenes[0].scene.run.step, 0.0101918 / 64, 1e-7);
}

}  // namespace
}  // namespace grainproof
