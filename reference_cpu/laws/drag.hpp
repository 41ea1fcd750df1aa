// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/fields.hpp"

namespace grainproof::reference {

/// Pa s; zero without a fluid.
inline double viscosity_of(const Flow& flow) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.viscosity; })
          return kind.viscosity;
        else
          return 0.0;
      },
      flow);
}

/// Inverse of the response time τ = ρ d²/(18 μ_f), 1/s (docs/laws/fields.md; Andrews 2.11).
inline double drag_rate(double density, double diameter, double viscosity) {
  return 18.0 * viscosity / (density * diameter * diameter);
}

/// Andrews 2.10, per mass.
inline Vec3 drag_acceleration(double rate, const Vec3& fluid_velocity, const Vec3& velocity) {
  return rate * (fluid_velocity - velocity);
}

}  // namespace grainproof::reference
