// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/contact_force.hpp"

namespace grainproof::reference {
namespace {

/// Springs and dashpots as they are at this overlap.
struct Response {
  double push;     ///< N
  double damping;  ///< η, N s/m
  ShearResponse shear;
};

/// Radius of the contact circle of a Hertz contact.
double circle(const ContactPoint& point) {
  return std::sqrt(point.effective_radius * point.overlap);
}

ShearResponse shared(const ShearResponse& full, double damping_ratio) {
  return {full.stiffness, damping_ratio * full.damping};
}

Response response(const PairLaws& laws, const ContactPoint& point, double root_mass) {
  if (laws.hertz.present()) {
    const double a = circle(point);
    return {laws.hertz.push(a, point.overlap), laws.hertz.damping(a, root_mass),
            shared(laws.hertz.shear(a, root_mass), laws.spring.damping_ratio)};
  }
  const double eta = laws.normal.damping_for(root_mass);
  return {laws.normal.stiffness * point.overlap, eta,
          shared({laws.spring.stiffness, eta}, laws.spring.damping_ratio)};
}

/// k_t of before over k_t of now, where the spring keeps its force while k_t grows (docs/laws/history.md).
double kept_share(const PairLaws& laws, const ContactPoint& point, const ContactSprings& springs) {
  const bool grows = springs.overlap > 0.0 && springs.overlap < point.overlap;
  if (!laws.spring.keeps_force || !laws.hertz.present() || !grows) return 1.0;
  return std::sqrt(springs.overlap / point.overlap);
}

double rolling_stiffness(const ContactPoint& point, const ShearResponse& shear) {
  return shear.stiffness * point.effective_radius * point.effective_radius;
}

}  // namespace

ContactForce contact_force(const PairLaws& laws, const ContactPoint& point, double elapsed,
                           ContactSprings& springs) {
  const double root_mass = std::sqrt(point.effective_mass);
  const Response now = response(laws, point, root_mass);
  const double separating = point.relative_velocity.dot(point.normal);
  double normal = now.push - now.damping * separating;
  if (laws.normal.no_tension) normal = std::max(normal, 0.0);
  const Vec3 slip = point.relative_velocity - separating * point.normal;
  if (laws.spring.present()) {
    const Vec3 kept = springs.displacement * kept_share(laws, point, springs);
    springs.displacement = laws.spring.turned(kept, point.normal) + slip * elapsed;
    if (laws.spring.keeps_force) springs.overlap = point.overlap;
    return {normal, laws.spring.force(springs.displacement, slip, normal, now.shear)};
  }
  if (laws.friction.coefficient == 0.0) return {normal, Vec3::Zero()};
  return {normal, laws.friction.force(slip, normal, now.damping, root_mass)};
}

Vec3 rolling_torque(const PairLaws& laws, const ContactPoint& point, const Vec3& spin, double normal_force,
                    double elapsed, ContactSprings& springs) {
  const Response now = response(laws, point, std::sqrt(point.effective_mass));
  const double arm = laws.rolling.coefficient * point.effective_radius;
  if (!laws.rolling.spring) return constant_torque(arm * now.push, spin, point.normal);
  springs.rolling_torque = wound_torque(springs.rolling_torque, arm * std::abs(normal_force),
                                        rolling_stiffness(point, now.shear), spin, point.normal, elapsed);
  return springs.rolling_torque;
}

Stored stored_in(const PairLaws& laws, const ContactPoint& point, const ContactSprings& springs) {
  const Response now = response(laws, point, std::sqrt(point.effective_mass));
  const double normal = laws.hertz.present() ? laws.hertz.potential(circle(point), point.overlap)
                                             : laws.normal.potential(point.overlap);
  const double tangential =
      laws.spring.present() ? 0.5 * now.shear.stiffness * springs.displacement.squaredNorm() : 0.0;
  const double rolling =
      laws.rolling.spring ? 0.5 * springs.rolling_torque.squaredNorm() / rolling_stiffness(point, now.shear)
                          : 0.0;
  return {now.push, normal, tangential, rolling};
}

}  // namespace grainproof::reference
