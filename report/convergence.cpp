// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/convergence.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace grainproof::report {
namespace {

/// A step's label as a number: "contact/64" is 1/64 of "contact", "1e-4" is seconds (base empty).
struct Label {
  std::string base;
  double value = 0.0;  ///< 0 where the label is neither
};

Label parsed(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::size_t digits = slash == std::string::npos ? 0 : slash + 1;
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data() + digits, text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !(number > 0.0)) return {};
  return slash == std::string::npos ? Label{"", number} : Label{text.substr(0, slash), 1.0 / number};
}

bool has_point_near(const Series& series, double x) {
  return std::any_of(series.points.begin(), series.points.end(),
                     [&](const auto& point) { return std::abs(point.first / x - 1.0) < 0.01; });
}

/// The points of an order carry seconds; its first label says what fraction the first of them is.
void add_order_points(const Row& order, Series& series) {
  if (order.points.empty() || !order.order_expected) return;
  const double first = parsed(order.order_expected->from).value;
  for (const auto& [seconds, error] : order.points) {
    const double x = first * seconds / order.points.front().first;
    if (x > 0.0 && !has_point_near(series, x)) series.points.emplace_back(x, error);
  }
}

Series series_of(const Line& line) {
  Series series{line.integrator + (line.set_up.empty() ? "" : ", " + line.set_up), line.engine, {}, {}};
  for (const Row& row : line.steps) {
    const double x = parsed(row.step).value;
    if (x <= 0.0) continue;
    series.points.emplace_back(x, row.error);
    series.bounds.emplace_back(x, row.tolerance);
  }
  if (line.order) add_order_points(*line.order, series);
  std::sort(series.points.begin(), series.points.end());
  return series;
}

std::string base_of(const Claim& claim) {
  for (const std::string& step : claim.steps)
    if (const Label label = parsed(step); label.value > 0.0) return label.base;
  return "";
}

}  // namespace

Plot convergence_plot(const std::string& case_name, const Claim& claim) {
  const std::string base = base_of(claim);
  Plot plot;
  plot.title = case_name + ": " + claim.quantity;
  plot.x_title = base.empty() ? "step / s" : "step / " + base + " time";
  plot.y_title = claim.samples > 1 ? std::string(name_of(claim.statistic)) + " error" : "error";
  plot.x_is_fraction = !base.empty();
  for (const Line& line : claim.lines) plot.series.push_back(series_of(line));
  return plot;
}

}  // namespace grainproof::report
