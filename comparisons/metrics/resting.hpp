// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "comparisons/measured.hpp"
#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof {

/// Deepest overlap in the last frame, m; negative where nothing touches.
Measured resting_overlap(const Scene& scene, const Observations& seen);

/// When the speed along the first frame's slip first reaches zero, s; linear between frames.
Measured stop_time(const Scene& scene, const Observations& seen);

/// How far the first moving particle has come along its first velocity by the last frame, m.
Measured stop_distance(const Scene& scene, const Observations& seen);

}  // namespace grainproof
