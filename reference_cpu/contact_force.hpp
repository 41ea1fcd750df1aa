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

/// Springs and dashpots as they are at one overlap.
struct ContactResponse {
  double push;     ///< N
  double damping;  ///< η, N s/m
  ShearResponse shear;
};

/// Radius of the contact circle of a Hertz contact.
inline double contact_circle(const ContactPoint& point) {
  return std::sqrt(point.effective_radius * point.overlap);
}

ContactResponse hertz_response(const PairLaws& laws, const ContactPoint& point, double root_mass);

inline ContactResponse linear_response(const PairLaws& laws, const ContactPoint& point, double root_mass) {
  const double eta = laws.normal.damping_for(root_mass);
  return {
      laws.normal.stiffness * point.overlap, eta, {laws.spring.stiffness, laws.spring.damping_ratio * eta}};
}

inline ContactResponse response(const PairLaws& laws, const ContactPoint& point, double root_mass) {
  return laws.hertz.present() ? hertz_response(laws, point, root_mass)
                              : linear_response(laws, point, root_mass);
}

/// k_t of before over k_t of now, while k_t grows (docs/laws/history.md).
double kept_share(const PairLaws& laws, const ContactPoint& point, const ContactSprings& springs);

/// What a spring that keeps its force is, at the stiffness of now.
inline void keep_force(const PairLaws& laws, const ContactPoint& point, ContactSprings& springs) {
  if (!laws.spring.keeps_force) return;
  springs.displacement *= kept_share(laws, point, springs);
  springs.overlap = point.overlap;
}

/// Of the tangential spring, which is turned, stretched by `moved` (m) and cut back.
inline Vec3 spring_friction(const PairLaws& laws, const ContactPoint& point, const Vec3& slip, double normal,
                            const ShearResponse& shear, const Vec3& moved, ContactSprings& springs) {
  keep_force(laws, point, springs);
  springs.displacement = laws.spring.turned(springs.displacement, point.normal) + moved;
  return laws.spring.force(springs.displacement, slip, normal, shear);
}

/// Of any laws, with their springs and dashpots as they are now. `friction_damping` is the η that friction
/// without memory adds to its slope. `of_spring`, of slip and normal force, is the friction of a tangential
/// spring, and brings it up to date.
template <class OfSpring>
ContactForce contact_force(const PairLaws& laws, const ContactPoint& point, const ContactResponse& now,
                           double friction_damping, double root_mass, const OfSpring& of_spring) {
  const double separating = point.relative_velocity.dot(point.normal);
  double normal = now.push - now.damping * separating;
  if (laws.normal.no_tension) normal = std::max(normal, 0.0);
  const Vec3 slip = point.relative_velocity - separating * point.normal;
  if (laws.spring.present()) return {normal, of_spring(slip, normal)};
  if (laws.friction.coefficient == 0.0) return {normal, Vec3::Zero()};
  return {normal, laws.friction.force(slip, normal, friction_damping, root_mass)};
}

inline ContactForce contact_force(const PairLaws& laws, const ContactPoint& point, double elapsed,
                                  ContactSprings& springs) {
  const double root_mass = std::sqrt(point.effective_mass);
  const ContactResponse now = response(laws, point, root_mass);
  const auto of_spring = [&](const Vec3& slip, double normal) {
    return spring_friction(laws, point, slip, normal, now.shear, slip * elapsed, springs);
  };
  return contact_force(laws, point, now, now.damping, root_mass, of_spring);
}

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
