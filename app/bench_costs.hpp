// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>

namespace grainproof::app {

/// What something costs, as a share of the time without it: 0.1 is a tenth.
struct CostBound {
  double mean;   ///< geometric
  double bound;  ///< of 95 %, one-sided, by Student's t of the logarithms
};

/// From times with it over times without, pair by pair. None of fewer than two.
std::optional<CostBound> cost_bound(std::span<const double> ratios);

}  // namespace grainproof::app
