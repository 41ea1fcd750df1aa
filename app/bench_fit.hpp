// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>

namespace grainproof::app {

/// t = intercept + factor N^exponent.
struct PowerLaw {
  double intercept, factor, exponent;
  double exponent_low, exponent_high;  ///< 95 % confidence; equal to `exponent` where no freedom is left
};

struct Timed {
  double particles, seconds;
};

/// Least squares of relative residuals, the intercept not negative. None with fewer than four sizes.
/// known_intercept: in s, where another fit has found it; large sizes alone say nothing about it.
std::optional<PowerLaw> fit_power_law(std::span<const Timed> points,
                                      std::optional<double> known_intercept = std::nullopt);

}  // namespace grainproof::app
