// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/searches/experiment.hpp"

#include <exception>

namespace grainproof {
namespace {

std::vector<Side> sides_of(std::span<const Scene> scenes, Engine& engine, std::span<const Trial> trials,
                           const Experiment& experiment, std::vector<Found>& found) try {
  std::vector<Scene> tried;
  for (const Trial& trial : trials) tried.push_back(experiment.set_up(scenes[trial.unknown], trial.at));
  const std::vector<Observations> seen = engine.observe_all(tried, {});
  std::vector<Side> sides;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    sides.push_back(experiment.judge(tried[k], seen.at(k)));
    found[trials[k].unknown].provenance = seen[k].provenance;
    found[trials[k].unknown].wall_s += seen[k].wall_s;
  }
  return sides;
} catch (const std::exception& failure) {
  return {trials.size(), Side{false, failure.what()}};
}

}  // namespace

std::vector<Found> search(std::span<const Scene> scenes, Engine& engine, std::span<const double> guesses,
                          double spread, double accuracy, const Experiment& experiment) {
  std::vector<Found> found(scenes.size());
  const std::vector<Measured> thresholds = bisect(
      guesses, spread, accuracy,
      [&](std::span<const Trial> trials) { return sides_of(scenes, engine, trials, experiment, found); });
  for (std::size_t i = 0; i < found.size(); ++i) found[i].value = thresholds[i];
  return found;
}

}  // namespace grainproof
