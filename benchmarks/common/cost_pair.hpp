// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <benchmark/benchmark.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/run_keeper.hpp"
#include "benchmarks/common/settings.hpp"
#include "model/engine.hpp"

namespace grainproof::bench {

/// How one of two is run that are held against one another.
struct CostSide {
  std::string engine;  ///< as the command line spells it
  std::function<Scene(std::int64_t particles)> scene;
  bool ledger = false;
  bool sentinels = false;
  bool zoned = false;  ///< on the path that knows all, whatever the scene would take
};

/// What one piece of a run took.
struct PieceTime {
  double wall_s = 0.0;
  double cpu_s = 0.0;  ///< of all threads of this process
};

/// A run with its keeper, as `grainproof run` drives it.
class KeptRun {
 public:
  KeptRun(const CostSide& side, std::int64_t particles, const Settings& settings);

  /// The piece, and of the look that follows it the share that the keeper gives to so many seconds of steps.
  PieceTime advance(std::int64_t steps);
  Run& run() { return *run_; }
  const app::RunKeeper& keeper() const { return keeper_; }
  double particles() const { return static_cast<double>(scene_.particles.size()); }
  double bytes_per_particle() const { return bytes_per_particle_; }

 private:
  PieceTime look(double stepped_s);

  Scene scene_;
  bool ledger_, sentinels_;
  std::unique_ptr<Engine> engine_;
  std::unique_ptr<Run> run_;
  app::RunKeeper keeper_;
  double bytes_per_particle_ = 0.0;
};

/// Two runs that go on side by side, by the same steps: both are started when the first is asked for, and
/// each goes on until it has been measured in every round.
class CostPair {
 public:
  CostPair(CostSide without, CostSide with, std::int64_t particles, double bar, const Settings& settings);

  /// One piece of one of the two. What keeps it from running is the benchmark's error.
  void measure(benchmark::State& state, bool with);

 private:
  void start();
  void choose_steps();

  std::array<CostSide, 2> sides_;
  std::int64_t size_;
  double bar_;
  const Settings& settings_;
  std::array<std::unique_ptr<KeptRun>, 2> runs_;
  std::string failure_;
  std::int64_t steps_ = 0;
  int measured_ = 0;
};

}  // namespace grainproof::bench
