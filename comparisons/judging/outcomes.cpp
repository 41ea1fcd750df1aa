// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/judging/outcomes.hpp"

#include <algorithm>
#include <exception>

#include "comparisons/judging/rows.hpp"

namespace grainproof {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Row judged(Row row, const std::string& complaint) {
  row.quantity = "outcome";
  row.reason = complaint;
  row.verdict = complaint.empty() ? Verdict::pass : Verdict::fail;
  return row;
}

std::string refusal_complaint(const Case& subject, const Expectation& says) {
  if (subject.refused.empty()) return "the input was not refused";
  return holds(subject.refused, says.reason)
             ? ""
             : "refused, but not for \"" + says.reason + "\": " + subject.refused;
}

/// Empty where the run goes wrong for the reason that the case states.
std::string failure_complaint(const Scene& scene, Engine& engine, const Expectation& says, Row& row) try {
  const Observations seen = engine.observe(scene, {});
  row.precision = seen.provenance.precision;
  row.wall_s += seen.wall_s;
  if (seen.outcome.status == Outcome::Status::completed) return "the run completed";
  return holds(seen.outcome.reason, says.reason)
             ? ""
             : "went wrong, but not for \"" + says.reason + "\": " + seen.outcome.reason;
} catch (const std::exception& failure) {
  return failure.what();
}

void note(std::vector<Refusal>& refusals, Refusal refusal) {
  if (std::find(refusals.begin(), refusals.end(), refusal) == refusals.end())
    refusals.push_back(std::move(refusal));
}

std::vector<Row> rows_of_failure(const Case& subject, Engine& engine, const Expectation& says,
                                 std::vector<Refusal>& refusals) {
  Row row = row_of(subject, engine.name(), "");
  std::string complaint;
  bool refused = false;
  for (const ResolvedScene& resolved : subject.scenes) {
    if (!matches(says, resolved)) continue;
    row.integrator = name_of(resolved.scene.run.integrator);
    if (const Support support = engine.supports(resolved.scene, {}); !support) {
      note(refusals, {support.because, row.integrator, ""});
      refused = true;
      continue;
    }
    ++row.samples;
    const std::string own = failure_complaint(resolved.scene, engine, says, row);
    if (complaint.empty()) complaint = own;
  }
  if (row.samples == 0 && refused) return {};
  if (row.samples == 0) complaint = "no point of the sweep matches `for`";
  return {judged(row, complaint)};
}

}  // namespace

std::vector<Row> rows_of_outcomes(const Case& subject, Engine& engine, std::vector<Refusal>& refusals) {
  std::vector<Row> rows;
  bool refusal_expected = false;
  for (const Expectation& says : subject.expectations) {
    refusal_expected |= says.outcome == "refused";
    if (!is_meant(says, engine.name())) continue;
    if (says.outcome == "refused")
      rows.push_back(judged(row_of(subject, engine.name(), ""), refusal_complaint(subject, says)));
    if (says.outcome == "went_wrong")
      for (Row& row : rows_of_failure(subject, engine, says, refusals)) rows.push_back(std::move(row));
  }
  if (!subject.refused.empty() && !refusal_expected)
    rows.push_back(judged(row_of(subject, engine.name(), ""), "the input was refused: " + subject.refused));
  return rows;
}

}  // namespace grainproof
