// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/claims.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/quantity.hpp"

namespace grainproof::report {
namespace {

/// The first element that fits, or a new one at the end.
template <class Element, class Fits>
Element& found_or_added(std::vector<Element>& elements, Fits fits) {
  const auto found = std::find_if(elements.begin(), elements.end(), fits);
  return found != elements.end() ? *found : elements.emplace_back();
}

void add_once(std::vector<std::string>& texts, const std::string& text) {
  if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
}

std::string set_up_of(const Row& row) {
  std::string text;
  for (const auto& [key, value] : row.values)
    if (key != "integrator") text += (text.empty() ? "" : ", ") + key + " " + value;
  return text;
}

Line& line_of(Claim& claim, const Row& row) {
  const std::string set_up = set_up_of(row);
  Line& line = found_or_added(claim.lines, [&](const Line& other) {
    return other.engine == row.engine && other.integrator == row.integrator && other.set_up == set_up;
  });
  line.engine = row.engine;
  line.integrator = row.integrator;
  line.set_up = set_up;
  return line;
}

void add(CaseRows& all, const Row& row) {
  if (row.quantity.empty() || row.verdict == Verdict::unsupported) {
    add_once(all.unsupported, row.engine + ": " + row.reason);
    return;
  }
  Claim& claim = found_or_added(all.claims, [&](const Claim& other) {
    return other.quantity == row.quantity && other.against == row.against && other.statistic == row.statistic;
  });
  claim.quantity = row.quantity;
  claim.against = row.against;
  claim.statistic = row.statistic;
  Line& line = line_of(claim, row);
  if (row.order || row.order_expected) {
    line.order = row;
  } else {
    claim.samples = std::max(claim.samples, row.samples);
    add_once(claim.steps, row.step);
    line.steps.push_back(row);
  }
}

}  // namespace

Verdict Line::verdict() const {
  std::vector<Row> rows = steps;
  if (order) rows.push_back(*order);
  return worst(rows);
}

std::optional<double> Line::margin() const {
  std::optional<double> smallest;
  for (const Row& row : steps) {
    if (std::isnan(row.tolerance)) continue;
    const double margin =
        row.error == 0.0 ? std::numeric_limits<double>::infinity() : row.tolerance / row.error;
    if (margin >= 0.0 && (!smallest || margin < *smallest)) smallest = margin;
  }
  return smallest;
}

CaseRows read_together(const std::vector<Row>& rows) {
  CaseRows all;
  if (!rows.empty()) all.name = rows.front().case_name;
  for (const Row& row : rows) add(all, row);
  return all;
}

Verdict worst(const std::vector<Row>& rows) {
  const auto any = [&](Verdict verdict) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.verdict == verdict; });
  };
  if (any(Verdict::fail)) return Verdict::fail;
  return any(Verdict::pass) ? Verdict::pass : Verdict::unsupported;
}

std::string_view name_of(Statistic statistic) {
  switch (statistic) {
    case Statistic::maximum:
      return "maximum";
    case Statistic::rms:
      return "rms";
    case Statistic::mean:
      return "mean";
    case Statistic::band:
      return "band";
  }
  return "unknown";
}

std::string title(const Claim& claim) {
  const Quantity* quantity = quantity_named(claim.quantity);
  std::string text = claim.quantity;
  if (claim.samples > 1)
    text += ", " + std::string(name_of(claim.statistic)) + " of " + std::to_string(claim.samples);
  if (!claim.against.empty()) text += ", against " + claim.against;
  if (claim.statistic == Statistic::band)
    return text + "; differences of the means in units of their 99.9 % band";
  return quantity ? text + "; errors relative to " + std::string(quantity->relative_to) : text;
}

}  // namespace grainproof::report
