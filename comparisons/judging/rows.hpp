// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "comparisons/judging/claims.hpp"
#include "comparisons/verdict.hpp"

namespace grainproof {

/// What every row of one engine on one case has in common.
Row row_of(const Case& subject, const std::string& engine, const std::string& precision);

/// The claim's rows: one a step that has a bound or a wanted sign, and one for an order, for every
/// combination of the other swept keys.
std::vector<Row> rows_of_claim(const Case& subject, const Claim& claim, const Row& common);

/// One row a thing that the engine does not support.
std::vector<Row> rows_of_refusals(const std::vector<Refusal>& refusals, const Row& common);

}  // namespace grainproof
