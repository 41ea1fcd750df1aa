// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/case_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <sstream>
#include <stdexcept>

namespace grainproof::testing {
namespace {

using app::CasePool;
using app::Progress;
using app::Tell;

constexpr std::size_t cases = 12;

/// The earlier the case, the longer it takes.
std::vector<Row> judge_slowly(std::size_t index, const Tell& tell) {
  std::this_thread::sleep_for(std::chrono::milliseconds(3 * (cases - index)));
  for (const char* engine : {" on one", " on another"})
    tell([=](Progress& progress) { progress.say(std::to_string(index) + engine); });
  Row row;
  row.case_name = std::to_string(index);
  return {row};
}

std::string shown_by(std::size_t threads) {
  std::ostringstream shown;
  Progress progress(shown, false, false);
  CasePool pool(cases, threads, judge_slowly);
  for (std::size_t k = 0; k < cases; ++k) shown << pool.next(progress).at(0).case_name << '\n';
  return shown.str();
}

TEST(CasePool, ShowsTheSameWhateverTheThreads) {
  const std::string alone = shown_by(1);
  EXPECT_EQ(alone.substr(0, 22), "0 on one\n0 on another\n");
  EXPECT_EQ(shown_by(5), alone);
}

TEST(CasePool, JudgesAsManyAtOnceAsItHasThreads) {
  std::atomic<int> now = 0, most = 0;
  std::ostringstream shown;
  Progress progress(shown, false, false);
  CasePool pool(cases, 3, [&](std::size_t index, const Tell& tell) {
    const int here = ++now;
    for (int seen = most; seen < here && !most.compare_exchange_weak(seen, here);) {
    }
    std::vector<Row> rows = judge_slowly(index, tell);
    --now;
    return rows;
  });
  for (std::size_t k = 0; k < cases; ++k) pool.next(progress);
  EXPECT_EQ(most, 3);
}

TEST(CasePool, ThrowsAtItsTurnWhatACaseThrewAndBeginsNoMore) {
  std::ostringstream shown;
  Progress progress(shown, false, false);
  std::atomic<std::size_t> begun = 0;
  {
    CasePool pool(1000, 2, [&](std::size_t index, const Tell& tell) {
      ++begun;
      if (index == 1) throw std::runtime_error("case 1");
      return judge_slowly(11, tell);
    });
    EXPECT_EQ(pool.next(progress).size(), 1u);
    EXPECT_THROW(pool.next(progress), std::runtime_error);
  }
  EXPECT_LT(begun, 1000u);
}

}  // namespace
}  // namespace grainproof::testing
