// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

#include "comparisons/measured.hpp"
#include "model/engine.hpp"

namespace grainproof {

/// What a search found for one scene, and at what cost.
struct Found {
  Measured value;
  Provenance provenance;
  double wall_s = 0.0;
};

/// The relative speed, m/s, above which two bodies leave each other's effect surfaces again. Bisects a
/// factor on the velocities of all moving particles; the start moves along with it, so that the
/// onset keeps its phase in the step. A run that has not parted at its end counts as stuck. `hints`
/// (NaN for none) are where to look first.
std::vector<Found> sticking_speed(std::span<const Scene> scenes, Engine& engine,
                                  std::span<const double> hints);

/// The longest step, s, with which the scene comes to rest. Speeds are compared at the middle and at the
/// end of the run, over a window of some oscillations each: they must fall, or be below a thousandth
/// of what they were at first. A run that goes wrong is unstable. Run::end says how long to look.
std::vector<Found> stable_step(std::span<const Scene> scenes, Engine& engine, std::span<const double> hints);

}  // namespace grainproof
