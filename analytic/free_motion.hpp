// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "analytic/linear_motion.hpp"
#include "analytic/solution.hpp"

namespace grainproof::analytic {

/// Solves a scene in which nothing meets: each particle under constant gravity and, with a flow, drag
/// towards a uniform stream (fields.4). Refuses a scene in which particles or walls might meet before
/// `until`.
Solution free_motion(const Scene& scene, const Vec3& gravity, const UniformFlow& flow, double until);

}  // namespace grainproof::analytic
