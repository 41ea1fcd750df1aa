// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/contact_force.hpp"

namespace grainproof::reference {
namespace {

double rolling_stiffness(const ContactPoint& point, const ShearResponse& shear) {
  return shear.stiffness * point.effective_radius * point.effective_radius;
}

}  // namespace

ContactResponse hertz_response(const PairLaws& laws, const ContactPoint& point, double root_mass) {
  const double a = contact_circle(point);
  const ShearResponse shear = laws.hertz.shear(a, root_mass);
  return {laws.hertz.push(a, point.overlap),
          laws.hertz.damping(a, root_mass),
          {shear.stiffness, laws.spring.damping_ratio * shear.damping}};
}

double kept_share(const PairLaws& laws, const ContactPoint& point, const ContactSprings& springs) {
  const bool grows = springs.overlap > 0.0 && springs.overlap < point.overlap;
  return laws.hertz.present() && grows ? std::sqrt(springs.overlap / point.overlap) : 1.0;
}

Vec3 rolling_torque(const PairLaws& laws, const ContactPoint& point, const Vec3& spin, double normal_force,
                    double elapsed, ContactSprings& springs) {
  const ContactResponse now = response(laws, point, std::sqrt(point.effective_mass));
  const double arm = laws.rolling.coefficient * point.effective_radius;
  if (!laws.rolling.spring) return constant_torque(arm * now.push, spin, point.normal);
  springs.rolling_torque = wound_torque(springs.rolling_torque, arm * std::abs(normal_force),
                                        rolling_stiffness(point, now.shear), spin, point.normal, elapsed);
  return springs.rolling_torque;
}

Stored stored_in(const PairLaws& laws, const ContactPoint& point, const ContactSprings& springs) {
  const ContactResponse now = response(laws, point, std::sqrt(point.effective_mass));
  const double normal = laws.hertz.present() ? laws.hertz.potential(contact_circle(point), point.overlap)
                                             : laws.normal.potential(point.overlap);
  const double tangential =
      laws.spring.present() ? 0.5 * now.shear.stiffness * springs.displacement.squaredNorm() : 0.0;
  const double rolling =
      laws.rolling.spring ? 0.5 * springs.rolling_torque.squaredNorm() / rolling_stiffness(point, now.shear)
                          : 0.0;
  return {now.push, normal, tangential, rolling};
}

}  // namespace grainproof::reference
