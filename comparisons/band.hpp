// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>

namespace grainproof {

/// Two engines' means of one number over runs that differ in their seeds, and how far chance alone may
/// take them apart.
struct BandDifference {
  double seen = 0.0;   ///< mean of the first
  double exact = 0.0;  ///< mean of the second
  double band = 0.0;   ///< half width of the 99.9 % confidence interval of their difference, by Welch

  /// |difference|/band; NaN where there is a NaN or fewer than two runs a side.
  double in_bands() const;
};

/// A number a run on each side, in any order and not of the same count.
BandDifference band_difference(std::span<const double> seen, std::span<const double> exact);

}  // namespace grainproof
