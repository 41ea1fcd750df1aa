// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "comparisons/judging/claims.hpp"
#include "comparisons/verdict.hpp"

namespace grainproof {

/// One row for each expectation that the input is refused or that runs go wrong, and a failing one
/// where the input was refused and no expectation says so.
std::vector<Row> rows_of_outcomes(const Case& subject, Engine& engine, std::vector<Refusal>& refusals);

}  // namespace grainproof
