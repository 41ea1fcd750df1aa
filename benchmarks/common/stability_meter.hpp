// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <tuple>

#include "benchmarks/common/kept_rows.hpp"
#include "benchmarks/common/made_once.hpp"
#include "benchmarks/common/settings.hpp"
#include "benchmarks/common/stability_cases.hpp"
#include "benchmarks/common/stable_step.hpp"

namespace grainproof::bench {

/// Measures points of the map of stable steps, from several threads at once.
class StabilityMeter {
 public:
  explicit StabilityMeter(const Settings& settings) : settings_(settings) {}

  /// The largest stable step against the prediction; where none is stable, the rate of growth.
  MeasuredRow limit(const std::string& engine, Integrator integrator, const StabilityCase& of);

  /// The source's figure: benchmarks/common/settling.hpp.
  MeasuredRow settled(const std::string& engine, Integrator integrator, double step, double end);

 private:
  /// Integrators that step alike have one prediction.
  using Stepping = std::tuple<const Scene*, decltype(analytic::LinearScheme::step), analytic::Weakening>;

  const Scene& resting(const StabilityCase& of);
  const Prediction& prediction_of(const Scene& resting, Integrator integrator);
  std::unique_ptr<SteppingEngine> take_engine(const std::string& name);
  void put_back(const std::string& name, std::unique_ptr<SteppingEngine> engine);
  MeasuredRow measured(const std::string& engine, const std::function<MeasuredRow(SteppingEngine&)>& measure);

  const Settings& settings_;
  MadeOnce<std::string, Scene> scenes_;
  MadeOnce<Stepping, Prediction> predictions_;
  std::mutex making_;  ///< of engines
  std::mutex mutex_;   ///< guards engines_
  std::multimap<std::string, std::unique_ptr<SteppingEngine>>
      engines_;  ///< idle, with what they have compiled
};

}  // namespace grainproof::bench
