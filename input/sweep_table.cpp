// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "input/sweep.hpp"

namespace grainproof::input {
namespace {

constexpr int most_samples = 1'000'000;

constexpr std::pair<std::string_view, Onset::Surface> surfaces[] = {{"body", Onset::Surface::body},
                                                                    {"effect", Onset::Surface::effect}};

Onset read_onset(const Node& node) {
  const Table table = node.table();
  table.only({"phases", "at"});
  return {static_cast<int>(table.at("phases").integer_within(1, most_samples)),
          table.at("at").choice(surfaces), node};
}

Orientations read_orientations(const Node& node) {
  if (!node.is_table()) return {static_cast<int>(node.integer_within(1, most_samples)), 0, node};
  const Table table = node.table();
  table.only({"samples", "seed"});
  return {static_cast<int>(table.at("samples").integer_within(1, most_samples)),
          table.at("seed").integer_within(0, largest_seed), node};
}

void read_steps(const Node& node, Sweep& sweep) {
  for (const Node& step : node.at_least_one()) sweep.steps.push_back(read_step(step));
}

void read_dither(const Node& node, Sweep& sweep) {
  if (node.boolean()) sweep.step_dither = node;
}

void read_integrators(const Node& node, Sweep& sweep) {
  for (const Node& element : node.at_least_one())
    sweep.integrators.push_back({read_integrator(element), element});
}

void read_offsets(const Node& node, Sweep& sweep) {
  sweep.offsets = node.at_least_one();
  for (const Node& offset : sweep.offsets) {
    if (offset.is_table()) offset.table().only({"diameters"});
    (void)(offset.is_table() ? offset.table().at("diameters") : offset).vector();
  }
}

void read_scales(const Node& node, Sweep& sweep) {
  sweep.scales = node.at_least_one();
  for (const Node& scale : sweep.scales) (void)scale.positive();
}

void read_numbers(const Node& node, const Document& document, Sweep& sweep) {
  const toml::node& target = number_at(document, node);
  sweep.numbers.push_back({std::string(node.name()), &target, node.at_least_one()});
  for (const Node& value : sweep.numbers.back().values) (void)value.number();
}

/// Whether anything below a table is drawn at random.
bool has_seed(const toml::node& node) {
  if (const auto* array = node.as_array())
    return std::any_of(array->begin(), array->end(), [](const toml::node& one) { return has_seed(one); });
  const auto* table = node.as_table();
  return table &&
         (table->contains("seed") || std::any_of(table->begin(), table->end(),
                                                 [](const auto& entry) { return has_seed(entry.second); }));
}

Seeds read_seeds(const Node& node, const Document& document) {
  const auto samples = static_cast<int>(node.integer_within(1, most_samples));
  const auto* particles = document.tree.get("particles");
  if (!particles || !has_seed(*particles)) node.refuse("seeds in a scene without a seed", "a seed to vary");
  return {samples, node};
}

void read_key(const Node& node, const Document& document, Sweep& sweep) {
  if (node.name() == "step") return read_steps(node, sweep);
  if (node.name() == "step_dither") return read_dither(node, sweep);
  if (node.name() == "onset") return void(sweep.onset = read_onset(node));
  if (node.name() == "integrator") return read_integrators(node, sweep);
  if (node.name() == "orientation") return void(sweep.orientations = read_orientations(node));
  if (node.name() == "seeds") return void(sweep.seeds = read_seeds(node, document));
  if (node.name() == "offset") return read_offsets(node, sweep);
  if (node.name() == "scale") return read_scales(node, sweep);
  read_numbers(node, document, sweep);
}

void check_dither(const Sweep& sweep) {
  if (!sweep.step_dither) return;
  if (!sweep.onset && !sweep.orientations)
    sweep.step_dither->refuse("onset or orientation beside it, which give the samples");
  for (const StepWish& step : sweep.steps)
    if (step.steps_per_contact == 0.0) step.place.refuse("\"contact/N\", since step_dither varies N");
}

}  // namespace

Sweep read_sweep(const Table& table, const Document& document) {
  Sweep sweep;
  const auto nodes = table.nodes();
  if (nodes.empty()) table.whole().refuse("an empty sweep", "at least one key, or no [sweep]");
  for (const Node& node : nodes) read_key(node, document, sweep);
  check_dither(sweep);
  return sweep;
}

double Sweep::size() const {
  const auto at_least_once = [](std::size_t count) {
    return static_cast<double>(std::max<std::size_t>(count, 1));
  };
  double product = at_least_once(steps.size()) * at_least_once(integrators.size()) *
                   at_least_once(scales.size()) * at_least_once(offsets.size());
  for (const NumberSweep& number : numbers) product *= at_least_once(number.values.size());
  return product * phases() * rotations() * seedings();
}

}  // namespace grainproof::input
