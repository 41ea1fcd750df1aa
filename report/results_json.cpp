// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/results_json.hpp"

#include <cmath>

#include "report/claims.hpp"
#include "report/run_summary.hpp"

namespace grainproof::report {
namespace {

using nlohmann::json;

json number(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json expected_order(const Row& row) {
  if (!row.order_expected) return nullptr;
  const OrderBound& bound = *row.order_expected;
  return {{"from", bound.from}, {"to", bound.to}, {"is", bound.is}, {"within", bound.within}};
}

json row_json(const Row& row) {
  const bool of_an_order = row.order || row.order_expected;
  return {{"case", row.case_name},
          {"engine", row.engine},
          {"precision", row.precision},
          {"integrator", row.integrator},
          {"quantity", row.quantity},
          {"against", row.against},
          {"statistic", name_of(row.statistic)},
          {"samples", row.samples},
          {"values", row.values},
          {"step", of_an_order || row.step.empty() ? json(nullptr) : json(row.step)},
          {"error", number(row.error)},
          {"tolerance", number(row.tolerance)},
          {"order", row.order ? number(*row.order) : json(nullptr)},
          {"order_expected", expected_order(row)},
          {"verdict", name_of(row.verdict)},
          {"reason", row.reason},
          {"wall_s", row.wall_s}};
}

}  // namespace

json results_json(const std::vector<Row>& rows, const Machine& machine) {
  json results = json::array();
  for (const Row& row : rows) results.push_back(row_json(row));
  return {{"schema", 1}, {"machine", machine_json(machine)}, {"results", results}};
}

}  // namespace grainproof::report
