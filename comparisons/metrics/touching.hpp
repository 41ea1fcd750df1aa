// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "comparisons/metrics/pairs.hpp"

namespace grainproof {

/// Pairs of particles whose bodies overlap, each once, periodic images included.
std::vector<Pair> touching_particles(const Scene& scene, const Frame& frame);

/// Particles that overlap a wall, by wall.
std::vector<Pair> touching_walls(const Scene& scene, const Frame& frame);

}  // namespace grainproof
