// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/scene_choice.hpp"

#include <algorithm>

#include "app/engines.hpp"
#include "app/resources.hpp"
#include "comparisons/quantity.hpp"
#include "model/errors.hpp"

namespace grainproof::app {
namespace {

std::string described(const SweepPoint& point) {
  std::string text = "step " + point.step + ", sample " + std::to_string(point.sample);
  for (const auto& [key, value] : point.values) text += ", " + key + " " + value;
  return text;
}

bool claims_ledger(const Case& subject) {
  return std::any_of(subject.expectations.begin(), subject.expectations.end(), [](const Expectation& claim) {
    const Quantity* quantity = quantity_named(claim.quantity);
    return quantity != nullptr && quantity->ledger;
  });
}

}  // namespace

ReadOptions reading_options(bool force) {
  ReadOptions options;
  options.force = force;
  for (const Quantity& quantity : quantities()) options.quantities.push_back(quantity.name);
  options.engines = engine_names();
  return options;
}

ChosenScene choose_scene(const std::filesystem::path& data, const std::string& name_or_path, int nth,
                         bool force, Progress& progress) {
  const ReadOptions options = reading_options(force);
  Case subject = read_case(find_case(data, name_or_path), options);
  if (!subject.refused.empty()) throw InputRefused(subject.refused);
  const std::size_t count = subject.scenes.size();
  if (nth < 0 || static_cast<std::size_t>(nth) > count)
    throw InputRefused(subject.name + " expands to " + std::to_string(count) +
                       (count == 1 ? " scene" : " scenes") + "; found --nth " + std::to_string(nth));
  ResolvedScene& chosen = subject.scenes.at(nth == 0 ? 0 : static_cast<std::size_t>(nth) - 1);
  if (nth == 0 && count > 1)
    progress.say(subject.name + " expands to " + std::to_string(count) + " scenes; taking the first (" +
                 described(chosen.point) + "), --nth N takes another");
  return {subject.name, std::move(chosen.scene), chosen.point.step_because, claims_ledger(subject)};
}

}  // namespace grainproof::app
