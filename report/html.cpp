// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/html.hpp"

#include <algorithm>

#include "report/claims.hpp"
#include "report/convergence.hpp"
#include "report/numbers.hpp"

namespace grainproof::report {
namespace {

constexpr const char* style =
    "body{font:15px/1.45 sans-serif;max-width:72em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:.6em 0 1.2em}"
    "th,td{padding:.15em .8em .15em 0;text-align:left;font-variant-numeric:tabular-nums}"
    "th{font-weight:600;border-bottom:1px solid #999}td.number,th.number{text-align:right}"
    ".pass{color:#00702c}.fail{color:#b00020;font-weight:600}.unsupported{color:#8a6100}"
    "h2{margin-top:2.2em}h3{font-weight:600;font-size:1em;margin-bottom:.2em}.note{color:#555}"
    "svg{max-width:100%;height:auto}";

std::string tag(const std::string& name, const std::string& inner, const std::string& css = "") {
  return "<" + name + (css.empty() ? "" : " class=\"" + css + "\"") + ">" + inner + "</" + name + ">";
}

std::string verdict_cell(Verdict verdict, const std::string& text) {
  return tag("td", text, name_of(verdict));
}

std::string head_of(const Claim& claim) {
  std::string cells = tag("th", "engine") + tag("th", "integrator") + tag("th", "set-up");
  for (const std::string& step : claim.steps) cells += tag("th", escaped(step), "number");
  for (const char* title : {"order", "expected", "tolerance/error"}) cells += tag("th", title, "number");
  return tag("tr", cells + tag("th", "verdict")) + "\n";
}

std::string step_cell(const Line& line, const std::string& step) {
  for (const Row& row : line.steps)
    if (row.step == step)
      return "<td class=\"number\" title=\"tolerance " + brief(row.tolerance) + "\">" + brief(row.error) +
             "</td>";
  return tag("td", "");
}

std::string order_cells(const Line& line) {
  const bool measured = line.order && line.order->order;
  const bool expected = line.order && line.order->order_expected;
  return tag("td", measured ? two_decimals(*line.order->order) : "", "number") +
         tag("td",
             expected
                 ? brief(line.order->order_expected->is) + " ± " + brief(line.order->order_expected->within)
                 : "",
             "number");
}

std::string row_of(const Claim& claim, const Line& line) {
  std::string cells =
      tag("td", escaped(line.engine)) + tag("td", escaped(line.integrator)) + tag("td", escaped(line.set_up));
  for (const std::string& step : claim.steps) cells += step_cell(line, step);
  const auto margin = line.margin();
  cells += order_cells(line) + tag("td", margin ? brief(*margin) : "", "number");
  return tag("tr", cells + verdict_cell(line.verdict(), name_of(line.verdict()))) + "\n";
}

std::string claim_html(const std::string& case_name, const Claim& claim) {
  std::string rows = head_of(claim);
  for (const Line& line : claim.lines) rows += row_of(claim, line);
  const Plot plot = convergence_plot(case_name, claim);
  return tag("h3", escaped(title(claim))) + "\n" + tag("table", rows) + "\n" +
         (plot.worth_drawing() ? svg(plot) : "");
}

std::string failures_html(const std::vector<Row>& rows) {
  std::string items;
  for (const Row& row : rows)
    if (row.verdict == Verdict::fail)
      items += tag("li",
                   escaped(row.engine + " " + row.integrator + " " + row.quantity + " " + row.step + ": " +
                           (row.reason.empty()
                                ? "error " + brief(row.error) + ", expected at most " + brief(row.tolerance)
                                : row.reason)),
                   "fail") +
               "\n";
  return items.empty() ? "" : tag("ul", items);
}

std::string case_html(const CaseReport& report) {
  const CaseRows all = read_together(report.rows);
  std::string text = "<h2 id=\"" + escaped(all.name) + "\">" + escaped(all.name) + " " +
                     tag("span", name_of(worst(report.rows)), name_of(worst(report.rows))) + "</h2>\n" +
                     tag("p", escaped(report.title)) + "\n" + failures_html(report.rows);
  for (const Claim& claim : all.claims) text += claim_html(all.name, claim);
  for (const std::string& line : all.unsupported)
    text += tag("p", "not supported: " + escaped(line), "note") + "\n";
  return text;
}

std::vector<std::string> engines_of(const std::vector<CaseReport>& cases) {
  std::vector<std::string> engines;
  for (const CaseReport& report : cases)
    for (const Row& row : report.rows)
      if (std::find(engines.begin(), engines.end(), row.engine) == engines.end())
        engines.push_back(row.engine);
  return engines;
}

std::string overview(const std::vector<CaseReport>& cases) {
  const auto engines = engines_of(cases);
  std::string head = tag("th", "case");
  for (const std::string& engine : engines) head += tag("th", escaped(engine));
  std::string rows = tag("tr", head) + "\n";
  for (const CaseReport& report : cases) {
    if (report.rows.empty()) continue;
    const std::string name = escaped(report.rows.front().case_name);
    std::string cells = tag("td", "<a href=\"#" + name + "\">" + name + "</a>");
    for (const std::string& engine : engines) {
      std::vector<Row> here;
      std::copy_if(report.rows.begin(), report.rows.end(), std::back_inserter(here),
                   [&](const Row& row) { return row.engine == engine; });
      cells += here.empty() ? tag("td", "") : verdict_cell(worst(here), name_of(worst(here)));
    }
    rows += tag("tr", cells) + "\n";
  }
  return tag("table", rows) + "\n";
}

}  // namespace

std::string html(const std::vector<CaseReport>& cases, const Machine& machine) {
  std::string body = tag("h1", "Grainproof: verification") + "\n" +
                     tag("p",
                         escaped("grainproof " + machine.version + ", " + machine.processor + ", " +
                                 std::to_string(machine.threads) + " threads, " + machine.system),
                         "note") +
                     "\n" + overview(cases);
  for (const CaseReport& report : cases) body += case_html(report);
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Grainproof: "
         "verification</title>"
         "<style>" +
         std::string(style) + "</style></head>\n<body>\n" + body + "</body></html>\n";
}

}  // namespace grainproof::report
