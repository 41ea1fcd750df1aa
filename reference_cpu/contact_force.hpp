// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "reference_cpu/laws/pair_laws.hpp"

namespace grainproof::reference {

/// All that a law may know of touching bodies; n points from body 1 to body 2.
struct ContactPoint {
  Vec3 normal;
  double overlap;          ///< of the bodies, m; positive
  Vec3 relative_velocity;  ///< of body 2 over body 1, m/s
  double effective_mass;   ///< kg
};

/// On body 2.
struct ContactForce {
  double normal;  ///< along n, spring and dashpot
  Vec3 friction;
};

inline ContactForce contact_force(const PairLaws& laws, const ContactPoint& point) {
  const double root_mass = std::sqrt(point.effective_mass);
  const double eta = laws.normal.damping_for(root_mass);
  const double separating = point.relative_velocity.dot(point.normal);
  const double normal = laws.normal.force(point.overlap, separating, eta);
  if (laws.friction.coefficient == 0.0) return {normal, Vec3::Zero()};
  const Vec3 slip = point.relative_velocity - separating * point.normal;
  return {normal, laws.friction.force(slip, normal, eta, root_mass)};
}

}  // namespace grainproof::reference
