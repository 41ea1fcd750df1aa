// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>
#include <utility>

namespace grainproof {

/// A number got from Observations, or NaN and the reason why there is none.
struct Measured {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string because;

  static Measured of(double number) { return {number, {}}; }
  static Measured none(std::string reason) {
    return {std::numeric_limits<double>::quiet_NaN(), std::move(reason)};
  }
  bool exists() const { return because.empty(); }
};

}  // namespace grainproof
