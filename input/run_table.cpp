// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>

#include "input/set_up.hpp"

namespace grainproof::input {
namespace {

constexpr std::pair<std::string_view, SumOrder> orders[] = {{"fast", SumOrder::fast},
                                                            {"canonical", SumOrder::canonical}};

constexpr std::pair<std::string_view, NeighbourSearch> searches[] = {
    {"automatic", NeighbourSearch::automatic},
    {"all_pairs", NeighbourSearch::all_pairs},
    {"cells", NeighbourSearch::cells},
    {"verlet_list", NeighbourSearch::verlet_list}};

constexpr std::string_view relative = "contact/";

double steps_per_contact(const Node& node) {
  const std::string text = node.text();
  double count = 0.0;
  if (text.starts_with(relative)) {
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + relative.size(), end, count);
    if (read.ec != std::errc{} || read.ptr != end) count = 0.0;
  }
  if (!(count >= 1.0 && count <= 1e9)) node.refuse("seconds, or \"contact/N\" with N from 1 to 1e9");
  return count;
}

RecordWish read_record(const Node& record) {
  constexpr double most = 1e6;
  if (!record.is_table()) record.refuse("{ every = SECONDS }, { steps = N } or { frames = N }");
  const Table table = record.table();
  table.only({"every", "steps", "frames"});
  const auto nodes = table.nodes();
  if (nodes.size() != 1) table.whole().refuse("a table with one of every, steps or frames");
  const Node& node = nodes.front();
  if (node.name() == "every") return {RecordWish::Kind::every, node.positive()};
  const auto kind = node.name() == "steps" ? RecordWish::Kind::steps : RecordWish::Kind::frames;
  return {kind, static_cast<double>(node.integer_within(1, static_cast<std::int64_t>(most)))};
}

/// Two radii deep, the centres of two spheres may meet, and their contact has no direction.
double read_overlap_limit(const Node& node) {
  const double limit = node.positive();
  if (!(limit < 2.0)) node.refuse("a number above 0 and below 2, where centres meet");
  return limit;
}

}  // namespace

Integrator read_integrator(const Node& node) {
  const std::string wanted = node.text();
  if (const auto found = integrator_named(wanted)) return *found;
  std::vector<std::string_view> known;
  for (const auto& [name, value] : integrator_names) known.push_back(name);
  node.refuse_name(known);
}

StepWish read_step(const Node& node) {
  if (node.is_table()) {
    const Node error = node.table().only({"error"}).at("error");
    StepWish wish{"error/" + error.label(), 0.0, 0.0, node};
    wish.error = error.number_within(1e-9, 0.5);
    return wish;
  }
  if (node.is_text()) return {node.text(), 0.0, steps_per_contact(node), node};
  const double seconds = node.positive();
  return {node.label(), seconds, 0.0, node};
}

double read_skin(const Node& node) {
  if (!node.is_text()) return node.not_negative();
  if (node.text() != "auto") node.refuse_name({"auto"});
  return RunSettings::searched_skin;
}

void read_run(const Table& table, SetUp& set_up) {
  table.only({"end", "step", "beyond_stability", "impact_speed", "order", "integrator", "neighbours", "skin",
              "overlap_limit", "record"});
  RunSettings& run = set_up.scene.run;
  run.end = table.at("end").positive();
  if (const auto step = table.find("step")) set_up.step = read_step(*step);
  set_up.beyond_stability = table.boolean("beyond_stability", false);
  if (const auto speed = table.find("impact_speed")) set_up.impact_speed = speed->positive();
  if (const auto order = table.find("order")) run.order = order->choice(orders);
  const auto integrator = table.find("integrator");
  run.integrator = integrator ? read_integrator(*integrator) : usual_integrator;
  if (const auto search = table.find("neighbours")) run.neighbours = search->choice(searches);
  if (const auto skin = table.find("skin")) run.skin = read_skin(*skin);
  if (const auto limit = table.find("overlap_limit")) run.overlap_limit = read_overlap_limit(*limit);
  if (const auto record = table.find("record")) set_up.record = read_record(*record);
}

}  // namespace grainproof::input
