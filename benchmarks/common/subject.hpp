// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "benchmarks/common/settings.hpp"
#include "model/engine.hpp"

namespace grainproof::bench {

/// A run that is measured again and again: started and warmed up when first asked for, then going on until it
/// has been measured in every round.
class Subject {
 public:
  using MakeScene = std::function<Scene(std::int64_t particles)>;

  /// `engine` as the command line spells it.
  Subject(std::string engine, MakeScene scene, std::int64_t particles, const Settings& settings,
          Request request = {});

  /// One measurement of about Settings::seconds, with the counters of a row. What keeps it from running is
  /// the benchmark's error.
  void measure(benchmark::State& state);

  /// Of one measurement of its own. Throws what keeps it from running.
  double step_seconds();

 private:
  void start();
  void warm_up();
  double timed_advance(std::int64_t steps);
  void choose_steps();

  std::string engine_name_;
  MakeScene make_scene_;
  std::int64_t size_;
  Request request_;
  const Settings& settings_;
  std::unique_ptr<Engine> engine_;
  std::unique_ptr<Run> run_;
  std::string failure_;
  double particles_ = 0.0;
  double skin_ = -1.0;  ///< m; negative leaves it to the engine
  double bytes_per_particle_ = 0.0;
  std::int64_t steps_ = 0;
  int measured_ = 0;
};

/// "opencl:single" as "engine:opencl/precision:single"; an engine without a choice computes in double.
std::string engine_key(const std::string& engine);

/// Registers `subject` under `name`, to be measured once.
void add_measurement(const std::string& name, const std::shared_ptr<Subject>& subject);

/// Bytes this process holds in memory now.
double resident_bytes();

/// Registers a benchmark of one iteration whose time is what `measure` says, in seconds.
void add_manual(const std::string& name, const std::function<void(benchmark::State&)>& measure);

}  // namespace grainproof::bench
