// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <benchmark/benchmark.h>

#include <optional>

#include "benchmarks/common/peer_deck.hpp"
#include "benchmarks/common/settings.hpp"
#include "comparisons/peers/process.hpp"

namespace grainproof::bench {

/// LAMMPS or LIGGGHTS on a scene: one process, or one with mpirun, a measurement; what counts is the loop
/// time it reports itself.
class PeerSubject {
 public:
  PeerSubject(PeerProgram program, Scene scene, int processes, double seconds);

  /// Seconds a step with `skin` (m), from `steps` steps. Throws EngineFailed.
  double step_seconds(double skin, std::int64_t steps);

  void use_skin(double skin) { skin_ = skin; }

  /// One measurement of about the seconds given, with the counters of a row.
  void measure(benchmark::State& state);

 private:
  Scene scene_;
  PeerProgram program_;
  int processes_;
  double seconds_;
  double skin_ = 0.0;
  std::int64_t steps_ = 0;
  double bytes_ = 0.0;
  TemporaryFolder folder_;
};

/// Whether it is installed, in one process and, where `processes` is more than one, in parallel.
bool peer_is_here(PeerProgram program, int processes);

}  // namespace grainproof::bench
