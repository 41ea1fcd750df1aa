// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "comparisons/verdict.hpp"
#include "report/machine.hpp"

namespace grainproof::report {

/// docs/results.md, results.json: {"schema": 1, "machine": {…}, "results": […]}. A number that does not
/// exist is null, as is the step of an order and the order of everything else.
nlohmann::json results_json(const std::vector<Row>& rows, const Machine& machine);

}  // namespace grainproof::report
