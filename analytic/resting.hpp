// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "analytic/passage_solution.hpp"

namespace grainproof::analytic {

/// Motion towards rest on a wall or a fixed sphere under constant gravity; linear.10 and linear.11.
Solution come_to_rest(const Scene& scene, const Encounter& encounter, double until);

/// Why gravity does not bring this encounter to rest on its partner; "" where it does.
std::string why_no_rest(const Encounter& encounter);

/// m g_n/k.
double resting_overlap(const Encounter& encounter);

}  // namespace grainproof::analytic
