// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <cmath>

#include "analytic/closed_forms.hpp"
#include "input/expectations.hpp"
#include "input/text.hpp"

namespace grainproof::input {
namespace {

constexpr std::pair<std::string_view, Statistic> statistics[] = {{"maximum", Statistic::maximum},
                                                                 {"rms", Statistic::rms},
                                                                 {"mean", Statistic::mean},
                                                                 {"band", Statistic::band}};

enum class Ending { refused, went_wrong };
constexpr std::pair<std::string_view, Ending> endings[] = {{"refused", Ending::refused},
                                                           {"went_wrong", Ending::went_wrong}};

/// Refuses a name that is none of those known, and where none are known takes any.
void check_name(const Node& node, std::string_view name, const std::vector<std::string_view>& known,
                const char* where = "") {
  if (!known.empty() && std::find(known.begin(), known.end(), name) == known.end())
    node.refuse(meant(name, known) + where);
}

void check_value(const Node& node, std::string_view number) {
  double value = 0.0;
  const char* const end = number.data() + number.size();
  const auto read = std::from_chars(number.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(value)) node.refuse("value:NUMBER");
}

/// An invariant goes by the name of its quantity.
std::string read_against(const Node& node, const std::string& quantity, const ReadOptions& options) {
  constexpr const char* behind = " behind the colon";
  std::string text = node.text();
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string kind = text.substr(0, colon), name = text.substr(std::min(colon + 1, text.size()));
  if (kind == "closed_form" && !name.empty())
    check_name(node, name, analytic::closed_form_names(), behind);
  else if (kind == "engine" && !name.empty())
    check_name(node, name.substr(0, name.find(':')), options.engines, behind);
  else if (kind == "invariant" && !name.empty())
    check_name(node, name, {quantity}, behind);
  else if (kind == "value" && !name.empty())
    check_value(node, name);
  else
    node.refuse("closed_form:NAME, engine:NAME, invariant:NAME or value:NUMBER");
  return text;
}

std::map<std::string, double> read_below(const Node& node) {
  if (!node.is_table()) return {{"", node.not_negative()}};
  std::map<std::string, double> out;
  for (const Node& bound : node.table().nodes()) out[std::string(bound.name())] = bound.not_negative();
  if (out.empty()) node.refuse("a bound for at least one step");
  return out;
}

OrderBound read_order(const Table& table) {
  table.only({"from", "to", "is", "within"});
  return {table.at("from").label(), table.at("to").label(), table.at("is").number(),
          table.at("within").positive()};
}

std::map<std::string, std::string> read_where(const Table& table) {
  std::map<std::string, std::string> out;
  for (const Node& node : table.nodes()) out[std::string(node.name())] = node.label();
  return out;
}

std::vector<std::string> read_engines(const Node& node, const ReadOptions& options) {
  std::vector<std::string> out;
  for (const Node& engine : node.at_least_one()) {
    out.push_back(engine.text());
    check_name(engine, out.back().substr(0, out.back().find(':')), options.engines);
  }
  return out;
}

void read_claim(const Table& table, const ReadOptions& options, Expectation& out) {
  const Node quantity = table.at("quantity");
  out.quantity = quantity.text();
  check_name(quantity, out.quantity, options.quantities);
  out.against = read_against(table.at("against"), out.quantity, options);
  if (const auto statistic = table.find("statistic")) {
    out.statistic = statistic->choice(statistics);
    if (out.statistic == Statistic::band && !out.against.starts_with("engine:"))
      statistic->refuse("a band against " + in_quotes(out.against), "against = \"engine:NAME\"");
  }
  if (const auto below = table.find("below")) out.below = read_below(*below);
  if (const auto order = table.find("order")) out.order = read_order(order->table());
  if (const auto ulps = table.find("ulps")) out.ulps = ulps->not_negative();
  if (const auto sign = table.find("sign")) {
    out.sign = static_cast<int>(sign->integer_within(-1, 1));
    if (*out.sign == 0) sign->refuse("-1 or 1");
  }
  if (out.below.empty() && !out.order && !out.sign)
    table.whole().refuse("an expectation of nothing", "below, order or sign");
}

Expectation read_expectation(const Table& table, const ReadOptions& options) {
  Expectation out;
  if (const auto outcome = table.find("outcome")) {
    table.only({"outcome", "reason", "for", "engines"});
    (void)outcome->choice(endings);
    out.outcome = outcome->text();
    out.reason = table.at("reason").text();
  } else {
    table.only(
        {"quantity", "against", "for", "statistic", "below", "order", "sign", "ulps", "engines", "outcome"});
    read_claim(table, options, out);
  }
  if (const auto where = table.find("for")) out.where = read_where(where->table());
  if (const auto engines = table.find("engines")) out.engines = read_engines(*engines, options);
  return out;
}

bool meets(const Expectation& expectation, const ResolvedScene& scene) {
  const SweepPoint& point = scene.point;
  return std::all_of(expectation.where.begin(), expectation.where.end(), [&](const auto& wanted) {
    if (wanted.first == "step") return wanted.second == point.step;
    if (wanted.first == "integrator") return wanted.second == name_of(scene.scene.run.integrator);
    const auto found = point.values.find(wanted.first);
    return found != point.values.end() && found->second == wanted.second;
  });
}

void check_step(const WrittenExpectation& written, const std::vector<const SweepPoint*>& met,
                const std::string& label) {
  const auto has_label = [&](const SweepPoint* point) { return point->step == label; };
  if (label.empty() || std::any_of(met.begin(), met.end(), has_label)) return;
  written.place.refuse("a bound for step " + in_quotes(label) + ", which is not swept",
                       "a step as the sweep or run.step writes it");
}

}  // namespace

std::vector<WrittenExpectation> read_expectations(const std::vector<Node>& tables,
                                                  const ReadOptions& options) {
  std::vector<WrittenExpectation> out;
  out.reserve(tables.size());
  for (const Node& node : tables) out.push_back({read_expectation(node.table(), options), node});
  return out;
}

void check_expectations(const std::vector<WrittenExpectation>& written,
                        const std::vector<ResolvedScene>& scenes) {
  for (const WrittenExpectation& one : written) {
    std::vector<const SweepPoint*> met;
    for (const ResolvedScene& scene : scenes)
      if (meets(one.expectation, scene)) met.push_back(&scene.point);
    if (met.empty())
      one.place.refuse("for = a point that the sweep doesn't have", "keys and values that are swept");
    for (const auto& [label, bound] : one.expectation.below) check_step(one, met, label);
    if (!one.expectation.order) continue;
    check_step(one, met, one.expectation.order->from);
    check_step(one, met, one.expectation.order->to);
  }
}

}  // namespace grainproof::input
