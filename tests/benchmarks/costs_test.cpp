// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "app/bench_costs.hpp"
#include "benchmarks/common/cost_pair.hpp"
#include "benchmarks/common/scenes.hpp"

namespace grainproof::bench {
namespace {

// Of 1, 2, 3 and 4 per cent: mean 2.5, deviation 1.29, Student's t of three degrees of freedom 2.353.
TEST(CostBound, IsStudentsOfTheLogarithms) {
  const std::array ratios{std::exp(0.01), std::exp(0.04), std::exp(0.02), std::exp(0.03)};
  const auto found = app::cost_bound(ratios);
  ASSERT_TRUE(found);
  EXPECT_NEAR(std::log1p(found->mean), 0.025, 1e-12);
  EXPECT_NEAR(std::log1p(found->bound), 0.025 + 2.3534 * 0.0129099 / 2.0, 1e-6);
}

TEST(CostBound, NarrowsWithPairsAndNeedsTwo) {
  EXPECT_FALSE(app::cost_bound(std::vector<double>{1.1}));
  std::vector<double> few{1.0, 1.1}, many;
  for (int k = 0; k < 15; ++k) many.insert(many.end(), few.begin(), few.end());
  const auto wide = app::cost_bound(few), narrow = app::cost_bound(many);
  EXPECT_NEAR(wide->mean, narrow->mean, 1e-12);
  EXPECT_GT(wide->bound, 0.3);
  EXPECT_LT(narrow->bound, 0.07);
}

Settings small_settings() {
  Settings settings;
  settings.data = GRAINPROOF_SOURCE;
  return settings;
}

CostSide gas_side(bool sentinels, bool ledger) {
  CostSide side;
  side.engine = "reference";
  side.sentinels = sentinels;
  side.ledger = ledger;
  side.scene = [](std::int64_t particles) { return gas(particles); };
  return side;
}

// Each piece is followed by a look, whose share is part of its time; and both sides stay at one state.
TEST(KeptRun, LooksAfterEachPieceAndChangesNoBit) {
  const Settings settings = small_settings();
  KeptRun without(gas_side(false, false), 200, settings), with(gas_side(true, false), 200, settings);
  EXPECT_EQ(with.keeper().last_good_step(), -1);
  for (int piece = 0; piece < 3; ++piece) {
    EXPECT_GT(without.advance(16).wall_s, 0.0);
    EXPECT_GT(with.advance(16).wall_s, 0.0);
    EXPECT_EQ(with.keeper().last_good_step(), with.run().counters().steps);
  }
  EXPECT_EQ(without.keeper().last_good_step(), -1);
  EXPECT_EQ(with.run().counters().steps, without.run().counters().steps);
  EXPECT_EQ(with.run().digest(), without.run().digest());
}

TEST(KeptRun, KeepsALedgerWhereItIsAsked) {
  const Settings settings = small_settings();
  KeptRun without(gas_side(false, false), 200, settings), with(gas_side(false, true), 200, settings);
  EXPECT_EQ(without.run().ledger().kinetic, 0.0);
  EXPECT_GT(with.run().ledger().kinetic, 0.0);
  EXPECT_EQ(with.run().digest(), without.run().digest());
}

}  // namespace
}  // namespace grainproof::bench
