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

}  // namespace

ContactForce contact_force(const PairLaws& laws, const ContactPoint& point, double elapsed,
                           Vec3& displacement) {
  const double root_mass = std::sqrt(point.effective_mass);
  const Response now = response(laws, point, root_mass);
  const double separating = point.relative_velocity.dot(point.normal);
  double normal = now.push - now.damping * separating;
  if (laws.normal.no_tension) normal = std::max(normal, 0.0);
  const Vec3 slip = point.relative_velocity - separating * point.normal;
  if (laws.spring.present()) {
    displacement = laws.spring.turned(displacement, point.normal) + slip * elapsed;
    return {normal, laws.spring.force(displacement, slip, normal, now.shear)};
  }
  if (laws.friction.coefficient == 0.0) return {normal, Vec3::Zero()};
  return {normal, laws.friction.force(slip, normal, now.damping, root_mass)};
}

Stored stored_in(const PairLaws& laws, const ContactPoint& point, const Vec3& displacement) {
  const Response now = response(laws, point, std::sqrt(point.effective_mass));
  const double normal = laws.hertz.present() ? laws.hertz.potential(circle(point), point.overlap)
                                             : laws.normal.potential(point.overlap);
  const double tangential =
      laws.spring.present() ? 0.5 * now.shear.stiffness * displacement.squaredNorm() : 0.0;
  return {now.push, normal, tangential};
}

}  // namespace grainproof::reference
