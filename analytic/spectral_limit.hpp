// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "analytic/schemes.hpp"

namespace grainproof::analytic {

/// Largest |eigenvalue| of the step over all parts of a system: what the fastest motion grows by a step.
double growth_a_step(const LinearScheme& scheme, const std::vector<LinearSystem>& parts, double h);

/// Largest step, s, below which no motion grows, to 1e-5 of itself. 0: already at a hundredth of the
/// undamped limit something grows. Infinity: nothing grows at 16 times that limit.
double spectral_limit(const LinearScheme& scheme, const std::vector<LinearSystem>& parts);

/// The same where the system itself depends on the step; `scale` is the undamped limit.
double spectral_limit(const LinearScheme& scheme,
                      const std::function<std::vector<LinearSystem>(double h)>& parts, double scale);

/// 2/ω of the fastest undamped motion: the scale of all limits.
double undamped_limit(const std::vector<LinearSystem>& parts);

}  // namespace grainproof::analytic
