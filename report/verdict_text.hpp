// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "comparisons/verdict.hpp"
#include "report/text_table.hpp"

namespace grainproof::report {

/// Everything judged of one case: one table a claim, a line an engine and integrator.
std::string case_text(const std::vector<Row>& rows, const std::string& case_title, const Paint& paint);

/// What failed and what was expected instead; empty where nothing failed.
std::string failures_text(const std::vector<Row>& rows, const Paint& paint);

/// A table of cases against engines, the counts, and the time it took.
std::string summary_text(const std::vector<Row>& rows, double wall_s, const Paint& paint);

}  // namespace grainproof::report
