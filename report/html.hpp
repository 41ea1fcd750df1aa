// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "comparisons/verdict.hpp"
#include "report/machine.hpp"

namespace grainproof::report {

struct CaseReport {
  std::string title;
  std::vector<Row> rows;
};

/// One page that needs nothing else: verdicts, tables and convergence plots.
std::string html(const std::vector<CaseReport>& cases, const Machine& machine);

}  // namespace grainproof::report
