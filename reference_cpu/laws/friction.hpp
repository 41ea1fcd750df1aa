// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "model/laws.hpp"
#include "model/vec3.hpp"

namespace grainproof::reference {

/// Friction of one pair of materials (docs/laws/friction.md; Andrews 2.2-2.5, 3.2). Every variant's
/// static force is a multiple of the slip speed, slope + slope_per_root_mass · sqrt(m) and, where
/// `with_dashpot`, the normal contact's η; dynamic friction is the limit of an infinite slope.
struct SlipFriction {
  double coefficient = 0.0;          ///< μ; zero is frictionless
  double slope = 0.0;                ///< N s/m
  double slope_per_root_mass = 0.0;  ///< N s/(m √kg)
  bool with_dashpot = false;

  /// Static force over slip speed, N s/m.
  double per_speed(double eta, double root_mass) const {
    return slope + slope_per_root_mass * root_mass + (with_dashpot ? eta : 0.0);
  }

  /// On body 2, from the slip velocity of body 2 over body 1 (E8: its unit vector, one minus).
  Vec3 force(const Vec3& slip, double normal_force, double eta, double root_mass) const {
    const double speed = slip.norm();
    if (speed == 0.0) return Vec3::Zero();
    const double magnitude =
        std::min(per_speed(eta, root_mass) * speed, coefficient * std::abs(normal_force));
    return slip * (-magnitude / speed);
  }
};

/// The normal stiffness and the time step are part of some variants.
SlipFriction slip_friction(const FrictionLaw& law, double normal_stiffness, double step);

}  // namespace grainproof::reference
