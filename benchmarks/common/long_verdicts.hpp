// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/common/long_run.hpp"

namespace grainproof::bench {

/// One thing that a long run has to show.
struct LongVerdict {
  double measured = 0.0, bound = 0.0;
  bool held = false;
  std::string because;                                      ///< why the bound is what it is
  std::vector<std::pair<std::int64_t, double>> curve = {};  ///< what was measured, against steps
};

/// What a run of this scene is judged by; a scheme that must fail is judged by when it does.
std::vector<std::string> long_quantities(const std::string& scene, Integrator integrator);

/// Throws RunWentWrong's message as EngineFailed where the run ended by itself and should not have.
LongVerdict long_verdict(const LongPlan& plan, const LongHistory& history, const std::string& quantity,
                         double unit_roundoff);

}  // namespace grainproof::bench
