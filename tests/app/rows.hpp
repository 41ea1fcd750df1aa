// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <string>

#include "comparisons/verdict.hpp"

namespace grainproof::testing {

inline Row step_row(const std::string& engine, const std::string& step, double error, double tolerance) {
  Row row;
  row.case_name = "bounce";
  row.engine = engine;
  row.precision = "double";
  row.integrator = "velocity_verlet";
  row.quantity = "restitution";
  row.against = "closed_form:bounce";
  row.statistic = Statistic::rms;
  row.step = step;
  row.samples = 256;
  row.error = error;
  row.tolerance = tolerance;
  row.verdict = error <= tolerance ? Verdict::pass : Verdict::fail;
  return row;
}

inline Row order_row(const std::string& engine, double order) {
  Row row = step_row(engine, "", std::abs(order - 1.0), 0.1);
  row.order = order;
  row.order_expected = OrderBound{"contact/8", "contact/32", 1.0, 0.1};
  row.points = {{8e-3, 0.1}, {4e-3, 0.05}, {2e-3, 0.025}};
  return row;
}

inline Row unsupported_row(const std::string& engine, const std::string& because) {
  Row row;
  row.case_name = "bounce";
  row.engine = engine;
  row.verdict = Verdict::unsupported;
  row.reason = because;
  return row;
}

}  // namespace grainproof::testing
