// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

namespace grainproof::input {

/// Whether a sphere of this density (kg/m³) and diameter (m) has a mass that can be written as a number.
inline bool has_a_mass(double density, double diameter) {
  return std::isnormal(density * std::pow(diameter, 3));
}

}  // namespace grainproof::input
