// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "comparisons/measured.hpp"
#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof {

/// Deepest overlap in the last frame, m; negative where nothing touches.
Measured resting_overlap(const Scene& scene, const Observations& seen);

/// Where the line through the last two frames of the slowing down reaches zero, s. The slowing down ends
/// where the speed along the first velocity, within one step of zero, falls by less than half of
/// what it fell before: a law without a static branch chatters from then on, on either side of zero.
Measured stop_time(const Scene& scene, const Observations& seen);

/// How far the first moving particle has come along its first velocity by the last frame, m.
Measured stop_distance(const Scene& scene, const Observations& seen);

}  // namespace grainproof
