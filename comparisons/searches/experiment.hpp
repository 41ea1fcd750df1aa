// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "comparisons/searches/bisection.hpp"
#include "comparisons/searches/searches.hpp"

namespace grainproof {

/// How one kind of search turns a trial into a run and a run into a side.
struct Experiment {
  std::function<Scene(const Scene& scene, double at)> set_up;
  std::function<Side(const Scene& tried, const Observations& seen)> judge;
};

/// Bisects the experiment's threshold for every scene, all scenes of a round in one observe_all.
std::vector<Found> search(std::span<const Scene> scenes, Engine& engine, std::span<const double> guesses,
                          double spread, double accuracy, const Experiment& experiment);

}  // namespace grainproof
