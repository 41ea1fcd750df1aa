// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "app/bench_suites.hpp"
#include "report/text_table.hpp"

namespace grainproof::app {

/// The rows of one suite as a table, and its fits and ratios in words.
std::string suite_text(const Suite& suite, const nlohmann::json& results, const report::Paint& paint);

}  // namespace grainproof::app
