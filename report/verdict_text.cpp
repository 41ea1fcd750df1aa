// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/verdict_text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "report/claims.hpp"
#include "report/numbers.hpp"

namespace grainproof::report {
namespace {

constexpr std::size_t most_failures_shown = 30;

/// At most three: the coarsest, the middle and the finest.
std::vector<std::string> shown_steps(const std::vector<std::string>& steps) {
  if (steps.size() <= 3) return steps;
  return {steps.front(), steps[steps.size() / 2], steps.back()};
}

std::string painted(Verdict verdict, const Paint& paint) {
  switch (verdict) {
    case Verdict::pass:
      return paint.green("pass");
    case Verdict::fail:
      return paint.red("FAIL");
    case Verdict::unsupported:
      return paint.yellow("unsupported");
  }
  return "";
}

std::string error_at(const Line& line, const std::string& step) {
  for (const Row& row : line.steps)
    if (row.step == step) return brief(row.error);
  return "–";
}

std::string order_text(const Line& line) {
  return line.order && line.order->order ? two_decimals(*line.order->order) : "–";
}

std::string expected_order_text(const Line& line) {
  if (!line.order || !line.order->order_expected) return "–";
  const OrderBound& bound = *line.order->order_expected;
  return brief(bound.is) + " ± " + brief(bound.within);
}

std::string margin_text(const Line& line) {
  const auto margin = line.margin();
  if (!margin) return "–";
  return std::isinf(*margin) ? "exact" : brief(*margin) + " ×";
}

bool any_order(const Claim& claim) {
  return std::any_of(claim.lines.begin(), claim.lines.end(),
                     [](const Line& line) { return line.order.has_value(); });
}

bool any_set_up(const Claim& claim) {
  return std::any_of(claim.lines.begin(), claim.lines.end(),
                     [](const Line& line) { return !line.set_up.empty(); });
}

std::vector<Column> columns_of(const Claim& claim, const std::vector<std::string>& steps) {
  std::vector<Column> columns{{"engine"}, {"integrator"}};
  if (any_set_up(claim)) columns.push_back({"set-up"});
  for (const std::string& step : steps) columns.push_back({"error at " + step, Align::right});
  if (any_order(claim)) columns.insert(columns.end(), {{"order", Align::right}, {"expected", Align::right}});
  columns.insert(columns.end(), {{"tolerance/error", Align::right}, {"verdict"}});
  return columns;
}

std::string claim_text(const Claim& claim, const Paint& paint) {
  const auto steps = shown_steps(claim.steps);
  TextTable table(columns_of(claim, steps));
  for (const Line& line : claim.lines) {
    std::vector<std::string> cells{line.engine, line.integrator};
    if (any_set_up(claim)) cells.push_back(line.set_up);
    for (const std::string& step : steps) cells.push_back(error_at(line, step));
    if (any_order(claim)) cells.insert(cells.end(), {order_text(line), expected_order_text(line)});
    cells.insert(cells.end(), {margin_text(line), painted(line.verdict(), paint)});
    table.add(cells);
  }
  return "  " + title(claim) + "\n" + table.text(paint, "    ");
}

std::string where_text(const Row& row) {
  std::string text = row.case_name + ", " + row.engine;
  if (!row.integrator.empty()) text += ", " + row.integrator;
  if (!row.step.empty()) text += ", step " + row.step;
  for (const auto& [key, value] : row.values)
    if (key != "integrator") text += ", " + key + " " + value;
  return text;
}

std::string expected_text(const Row& row) {
  if (row.order_expected)
    return "measured order " + (row.order ? two_decimals(*row.order) : "none") + " of " + row.quantity +
           " from " + row.order_expected->from + " to " + row.order_expected->to + ", expected " +
           brief(row.order_expected->is) + " ± " + brief(row.order_expected->within);
  std::string text = row.quantity.empty() ? "" : row.quantity;
  if (!row.against.empty()) text += " against " + row.against;
  text += ": error " + brief(row.error);
  return std::isnan(row.tolerance) ? text : text + ", expected at most " + brief(row.tolerance);
}

std::size_t count(const std::vector<Row>& rows, Verdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return row.verdict == verdict; }));
}

template <class Key>
std::vector<std::string> distinct(const std::vector<Row>& rows, Key key) {
  std::vector<std::string> values;
  for (const Row& row : rows)
    if (std::find(values.begin(), values.end(), key(row)) == values.end()) values.push_back(key(row));
  return values;
}

std::string cell_text(const std::vector<Row>& rows, const Paint& paint) {
  if (rows.empty()) return "–";
  const std::size_t failed = count(rows, Verdict::fail);
  const std::size_t judged = failed + count(rows, Verdict::pass);
  if (failed > 0) return paint.red("FAIL " + std::to_string(failed) + " of " + std::to_string(judged));
  return judged > 0 ? paint.green("pass " + std::to_string(judged)) : paint.yellow("unsupported");
}

std::string counts_text(const std::vector<Row>& rows, double wall_s, const Paint& paint) {
  const std::size_t failed = count(rows, Verdict::fail);
  const std::string failures = std::to_string(failed) + " failed";
  return std::to_string(count(rows, Verdict::pass)) + " passed, " +
         (failed > 0 ? paint.red(failures) : failures) + ", " +
         std::to_string(count(rows, Verdict::unsupported)) + " not supported; " + duration(wall_s) + "\n";
}

}  // namespace

std::string case_text(const std::vector<Row>& rows, const std::string& case_title, const Paint& paint) {
  const CaseRows all = read_together(rows);
  std::string text = paint.bold(all.name) + (case_title.empty() ? "" : "  " + case_title) + "  " +
                     painted(worst(rows), paint) + "\n";
  for (const Claim& claim : all.claims) text += claim_text(claim, paint);
  for (const std::string& line : all.unsupported)
    text += "  " + paint.yellow("not supported") + "  " + line + "\n";
  return text + "\n";
}

std::string failures_text(const std::vector<Row>& rows, const Paint& paint) {
  std::ostringstream text;
  std::size_t shown = 0;
  for (const Row& row : rows) {
    if (row.verdict != Verdict::fail || ++shown > most_failures_shown) continue;
    text << paint.red("FAIL") << "  " << where_text(row) << "\n      " << expected_text(row) << "\n";
    if (!row.reason.empty()) text << "      " << row.reason << "\n";
  }
  if (shown > most_failures_shown)
    text << "… and " << shown - most_failures_shown << " more; --json has them all\n";
  return text.str();
}

std::string summary_text(const std::vector<Row>& rows, double wall_s, const Paint& paint) {
  const auto engines = distinct(rows, [](const Row& row) { return row.engine; });
  std::vector<Column> columns{{"case"}};
  for (const std::string& engine : engines) columns.push_back({engine});
  TextTable table(columns);
  for (const std::string& name : distinct(rows, [](const Row& row) { return row.case_name; })) {
    std::vector<std::string> cells{name};
    for (const std::string& engine : engines) {
      std::vector<Row> here;
      std::copy_if(rows.begin(), rows.end(), std::back_inserter(here),
                   [&](const Row& row) { return row.case_name == name && row.engine == engine; });
      cells.push_back(cell_text(here, paint));
    }
    table.add(cells);
  }
  return table.text(paint) + "\n" + counts_text(rows, wall_s, paint);
}

}  // namespace grainproof::report
