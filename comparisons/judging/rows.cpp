// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/judging/rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "comparisons/band.hpp"
#include "comparisons/statistic.hpp"
#include "comparisons/tolerance.hpp"

namespace grainproof {
namespace {

/// The findings of one step of the sweep, over which a statistic is taken.
struct StepGroup {
  std::string label;
  std::vector<const Finding*> findings;
  double step = 0.0;  ///< s, mean over the samples
  double statistic = 0.0;
  double mean = 0.0;
  double unit_roundoff = 0.0;
  double wall_s = 0.0;
  std::string because;  ///< of the first sample without a number
  std::string remark;   ///< what a band was made of
};

/// All steps of one combination of the other swept keys and the integrator.
struct SweepGroup {
  std::string integrator;
  std::map<std::string, std::string> values;
  std::vector<StepGroup> steps;
};

template <class Group, class Same>
Group& group_in(std::vector<Group>& groups, Same same, Group fresh) {
  const auto found = std::find_if(groups.begin(), groups.end(), same);
  return found != groups.end() ? *found : groups.emplace_back(std::move(fresh));
}

std::string text(double number) {
  std::ostringstream out;
  out.precision(4);
  out << number;
  return out.str();
}

/// Says how far the means are apart, so that a row that passes shows it too.
double in_bands(StepGroup& group) {
  if (!group.because.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> seen;
  std::vector<double> exact;
  for (const Finding* finding : group.findings) {
    seen.push_back(finding->seen);
    exact.push_back(finding->exact);
  }
  const BandDifference difference = band_difference(seen, exact);
  if (group.findings.size() < 2 && group.because.empty())
    group.because = "a band needs two samples or more; sweep.seeds gives them";
  group.remark = "mean " + text(difference.seen) + " against " + text(difference.exact) + ", 99.9 % band ± " +
                 text(difference.band);
  return difference.in_bands();
}

void summarise(StepGroup& group, const Case& subject, Statistic statistic) {
  std::vector<double> errors;
  for (const Finding* finding : group.findings) {
    const ResolvedScene& resolved = subject.scenes[finding->scene];
    errors.push_back(finding->error.value);
    group.step += resolved.scene.run.step / static_cast<double>(group.findings.size());
    group.unit_roundoff = std::max(group.unit_roundoff, finding->unit_roundoff);
    group.wall_s += finding->wall_s;
    if (!group.because.empty() || std::isfinite(finding->error.value)) continue;
    group.because = "sample " + std::to_string(resolved.point.sample) + ": " +
                    (finding->error.exists() ? "the error is not finite" : finding->error.because);
  }
  group.statistic = statistic == Statistic::band ? in_bands(group) : statistic_of(statistic, errors);
  group.mean = mean_of(errors);
}

std::vector<SweepGroup> grouped(const Case& subject, const Claim& claim) {
  std::vector<SweepGroup> groups;
  for (const Finding& finding : claim.findings) {
    const ResolvedScene& resolved = subject.scenes[finding.scene];
    const std::string integrator(name_of(resolved.scene.run.integrator));
    SweepGroup& sweep = group_in(
        groups,
        [&](const SweepGroup& g) { return g.values == resolved.point.values && g.integrator == integrator; },
        SweepGroup{integrator, resolved.point.values, {}});
    StepGroup fresh;
    fresh.label = resolved.point.step;
    group_in(
        sweep.steps, [&](const StepGroup& g) { return g.label == resolved.point.step; }, std::move(fresh))
        .findings.push_back(&finding);
  }
  for (SweepGroup& sweep : groups)
    for (StepGroup& step : sweep.steps) summarise(step, subject, claim.says->statistic);
  return groups;
}

std::optional<double> bound_for(const Expectation& says, const std::string& label) {
  if (const auto own = says.below.find(label); own != says.below.end()) return own->second;
  if (const auto any = says.below.find(""); any != says.below.end()) return any->second;
  return std::nullopt;
}

/// Empty where the statistic and the sign are as claimed.
std::string complaint(const StepGroup& step, const Expectation& says, double bar, bool bounded) {
  if (!step.because.empty()) return step.because;
  if (bounded && !within(step.statistic, bar) && !step.remark.empty())
    return step.remark + ": apart by " + text(step.statistic) + " bands";
  if (bounded && !within(step.statistic, bar))
    return "error " + text(step.statistic) + " is above " + text(bar);
  const bool sign_holds = !says.sign || step.mean * static_cast<double>(*says.sign) > 0.0;
  return sign_holds ? "" : "the mean error " + text(step.mean) + " has the wrong sign";
}

std::optional<Row> row_of_step(const StepGroup& step, const Expectation& says, Row row) {
  const std::optional<double> bound = bound_for(says, step.label);
  if (!bound && !(says.sign && says.below.empty())) return std::nullopt;
  row.step = step.label;
  row.samples = static_cast<int>(step.findings.size());
  row.error = step.statistic;
  if (bound) row.tolerance = tolerance(*bound, says.ulps, step.unit_roundoff);
  row.wall_s = step.wall_s;
  row.reason = complaint(step, says, row.tolerance, bound.has_value());
  row.verdict = row.reason.empty() ? Verdict::pass : Verdict::fail;
  if (row.verdict == Verdict::pass) row.reason = step.remark;
  return row;
}

const StepGroup* step_named(const SweepGroup& sweep, const std::string& label) {
  const auto found = std::find_if(sweep.steps.begin(), sweep.steps.end(),
                                  [&](const StepGroup& step) { return step.label == label; });
  return found == sweep.steps.end() ? nullptr : &*found;
}

/// Points that the order is fitted to; `row.reason` says which were left out, or why there are none.
void take_points(const SweepGroup& sweep, const Expectation& says, Row& row) {
  const StepGroup* from = step_named(sweep, says.order->from);
  const StepGroup* to = step_named(sweep, says.order->to);
  if (!from || !to) {
    row.reason = "no step \"" + (from ? says.order->to : says.order->from) + "\" in the sweep";
    return;
  }
  const auto [shortest, longest] = std::minmax(from->step, to->step);
  std::string at_floor;
  for (const StepGroup& step : sweep.steps) {
    if (step.step < shortest || step.step > longest) continue;
    if (!step.because.empty()) row.reason = step.label + ", " + step.because;
    row.samples += static_cast<int>(step.findings.size());
    row.wall_s += step.wall_s;
    if (std::abs(step.statistic) <= round_off_floor(says.ulps, step.unit_roundoff))
      at_floor += (at_floor.empty() ? "" : ", ") + step.label;
    else
      row.points.emplace_back(step.step, step.statistic);
  }
  if (row.reason.empty() && !at_floor.empty()) row.reason = "left out, at the round-off floor: " + at_floor;
}

Row row_of_order(const SweepGroup& sweep, const Expectation& says, Row row) {
  row.order_expected = says.order;
  row.tolerance = says.order->within;
  take_points(sweep, says, row);
  const bool broken = std::any_of(row.points.begin(), row.points.end(),
                                  [](const auto& point) { return !std::isfinite(point.second); });
  if (broken || (row.points.empty() && !row.reason.empty())) return row;
  if (row.points.size() < 2) {
    row.reason = "fewer than two steps are above the round-off floor; " + row.reason;
    return row;
  }
  row.order = order_of_convergence(row.points);
  row.error = std::abs(*row.order - says.order->is);
  row.verdict = within(row.error, row.tolerance) ? Verdict::pass : Verdict::fail;
  if (row.verdict == Verdict::fail)
    row.reason = "order " + text(*row.order) + " is not " + text(says.order->is) + " ± " +
                 text(says.order->within) + (row.reason.empty() ? "" : "; " + row.reason);
  return row;
}

}  // namespace

Row row_of(const Case& subject, const std::string& engine, const std::string& precision) {
  Row row;
  row.case_name = subject.name;
  row.engine = engine;
  row.precision = precision;
  return row;
}

std::vector<Row> rows_of_claim(const Case& subject, const Claim& claim, const Row& common) {
  Row row = common;
  row.quantity = claim.says->quantity;
  row.against = claim.says->against;
  row.statistic = claim.says->statistic;
  if (!claim.impossible.empty()) {
    row.reason = claim.impossible;
    return {row};
  }
  std::vector<Row> rows;
  for (const SweepGroup& sweep : grouped(subject, claim)) {
    row.integrator = sweep.integrator;
    row.values = sweep.values;
    for (const StepGroup& step : sweep.steps)
      if (auto own = row_of_step(step, *claim.says, row)) rows.push_back(std::move(*own));
    if (claim.says->order) rows.push_back(row_of_order(sweep, *claim.says, row));
  }
  return rows;
}

std::vector<Row> rows_of_refusals(const std::vector<Refusal>& refusals, const Row& common) {
  std::vector<Row> rows;
  for (const Refusal& refusal : refusals) {
    Row row = common;
    row.integrator = refusal.integrator;
    row.quantity = refusal.quantity;
    row.verdict = Verdict::unsupported;
    row.reason = refusal.because;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace grainproof
