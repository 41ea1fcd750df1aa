// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "model/laws.hpp"

namespace grainproof::reference {

/// Linear spring and dashpot of one pair of materials (docs/laws/linear.md; Andrews 2.1).
/// The dashpot is η = damping + damping_per_root_mass · sqrt(m): one of the two is zero.
struct SpringDashpot {
  double stiffness = 0.0;              ///< k, N/m
  double damping = 0.0;                ///< N s/m
  double damping_per_root_mass = 0.0;  ///< N s/(m √kg)
  bool no_tension = false;

  double damping_for(double root_mass) const { return damping + damping_per_root_mass * root_mass; }

  /// Along n, on body 2: k δ − η u_n, where u_n > 0 separates. Never negative with no_tension.
  double force(double overlap, double normal_velocity, double eta) const {
    const double sum = stiffness * overlap - eta * normal_velocity;
    return no_tension ? std::max(sum, 0.0) : sum;
  }

  double potential(double overlap) const { return 0.5 * stiffness * overlap * overlap; }

  /// Half a period of the free contact of effective mass m, s. Without one (critical or more
  /// damping) that of the undamped spring.
  double contact_time(double mass) const;
};

SpringDashpot spring_dashpot(const LinearNormal& law);

/// Share ζ of the critical damping, η = 2 ζ sqrt(m k), that rebounds with this restitution when
/// the dashpot may pull (Andrews 2.17).
double damping_ratio(double restitution);

/// The same when the force is clamped at zero (Schwager and Pöschel 2007); restitution above zero.
double damping_ratio_without_tension(double restitution);

}  // namespace grainproof::reference
