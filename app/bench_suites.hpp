// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>

#include "app/bench_session.hpp"
#include "report/text_table.hpp"

namespace grainproof::app {

struct ShownColumn {
  const char* key;    ///< of a row
  const char* title;  ///< with its unit
};

/// By hand, a row a suite of `grainproof bench`.
struct Suite {
  const char* name;
  const char* what;
  void (*measure)(BenchSession& session);
  std::span<const ShownColumn> columns;  ///< of its table
};

std::span<const Suite> bench_suites();

/// Thread counts to measure with: one, and all there are.
std::vector<int> thread_counts(const BenchSession& session);

/// Those of `sizes` that the user has not excluded; never none.
std::vector<std::int64_t> within_limits(const BenchSession& session, std::vector<std::int64_t> sizes);

/// bench_scaling.cpp
void measure_scaling(BenchSession& session);
/// bench_stability.cpp
void measure_stability(BenchSession& session);
/// bench_costs.cpp
void measure_costs(BenchSession& session);
void conclude_costs(BenchSession& session, const std::vector<Sample>& samples);

/// What follows from the samples of a suite, into BenchSession::extra; bench_conclusions.cpp and
/// bench_accuracy.cpp.
void conclude_neighbours(BenchSession& session, const std::vector<Sample>& samples);
void conclude_features(BenchSession& session, const std::vector<Sample>& samples);
void conclude_peers(BenchSession& session, const std::vector<Sample>& samples);
void conclude_accuracy(BenchSession& session);

}  // namespace grainproof::app
