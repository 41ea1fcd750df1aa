// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

#include "analytic/encounter.hpp"

namespace grainproof::analytic {

/// Friction as min(viscosity |u_t|, coefficient |F_n|): every static branch of friction.2 is
/// proportional to the slip speed.
struct SlipFriction {
  double coefficient = 0.0;                                    ///< 0 without friction
  double viscosity = std::numeric_limits<double>::infinity();  ///< N s/m; infinite without a static branch

  bool acts() const { return coefficient > 0.0 && viscosity > 0.0; }
};

/// None for a friction that remembers: it is no function of the slip speed.
SlipFriction slip_friction(const Encounter& encounter, double step);

}  // namespace grainproof::analytic
