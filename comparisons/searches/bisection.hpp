// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/measured.hpp"

namespace grainproof {

/// On which side of the wanted threshold a point lies, or why that cannot be told.
struct Side {
  bool above = false;
  std::string because;
};

/// A point to try for one of the unknowns.
struct Trial {
  std::size_t unknown;
  double at;
};

/// All trials of one round; one side a trial.
using AskSides = std::function<std::vector<Side>(std::span<const Trial> trials)>;

/// The positive thresholds of several unknowns, bisected side by side so that an engine gets all trials
/// of a round at once. Starts with `guess` ± a relative `spread`, which widens until it holds the
/// threshold, and ends when the bracket is narrower than `accuracy`, relative.
std::vector<Measured> bisect(std::span<const double> guesses, double spread, double accuracy,
                             const AskSides& ask);

}  // namespace grainproof
