// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "reference_cpu/laws/pair_laws.hpp"

namespace grainproof::reference {

/// All that a law may know of touching bodies; n points from body 1 to body 2.
struct ContactPoint {
  Vec3 normal;
  double overlap;           ///< of the bodies, m; positive
  Vec3 relative_velocity;   ///< of body 2 over body 1 where they touch, m/s
  double effective_mass;    ///< kg
  double effective_radius;  ///< m; used by Hertz contacts and rolling resistance
};

/// On body 2.
struct ContactForce {
  double normal;  ///< along n, spring and dashpot
  Vec3 friction;
};

/// What a contact remembers from one evaluation of the forces to the next.
struct ContactSprings {
  Vec3 displacement = Vec3::Zero();    ///< ζ, m
  Vec3 rolling_torque = Vec3::Zero();  ///< on body 2, N m
  double overlap = 0.0;                ///< m, at that evaluation; zero where no law asks for it
};

/// Of linear springs and friction without memory.
inline ContactForce contact_force(const PairLaws& laws, const ContactPoint& point) {
  const double root_mass = std::sqrt(point.effective_mass);
  const double eta = laws.normal.damping_for(root_mass);
  const double separating = point.relative_velocity.dot(point.normal);
  const double normal = laws.normal.force(point.overlap, separating, eta);
  if (laws.friction.coefficient == 0.0) return {normal, Vec3::Zero()};
  const Vec3 slip = point.relative_velocity - separating * point.normal;
  return {normal, laws.friction.force(slip, normal, eta, root_mass)};
}

/// Of any laws. The tangential spring is stretched for `elapsed` (s) and brought up to date.
ContactForce contact_force(const PairLaws& laws, const ContactPoint& point, double elapsed,
                           ContactSprings& springs);

/// Rolling resistance on body 2, N m. `spin` is that of body 2 over body 1, rad/s. Its spring is wound for
/// `elapsed` (s) and brought up to date.
Vec3 rolling_torque(const PairLaws& laws, const ContactPoint& point, const Vec3& spin, double normal_force,
                    double elapsed, ContactSprings& springs);

/// What the springs of a contact push and hold.
struct Stored {
  double push;               ///< normal force of the overlap alone, N
  double normal_energy;      ///< J
  double tangential_energy;  ///< J
  double rolling_energy;     ///< J
};

Stored stored_in(const PairLaws& laws, const ContactPoint& point, const ContactSprings& springs);

}  // namespace grainproof::reference
