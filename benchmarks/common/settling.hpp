// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "model/engine.hpp"

/// The source's figure: a sphere let go on a plane that it just touches, and how far from m g/k it comes to
/// rest, against the step (Andrews' draft, 4.4.1).
namespace grainproof::bench {

/// Steps up to beyond where the source's scheme breaks, s.
std::vector<double> settling_steps(bool quick);

struct Settled {
  double error;  ///< largest |overlap − m g/k| over its last 64 steps, in m g/k
  bool went_wrong;
};

Settled settle_overlap(SteppingEngine& engine, Integrator integrator, double step, double end);

}  // namespace grainproof::bench
