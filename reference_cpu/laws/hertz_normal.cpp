// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/hertz_normal.hpp"

#include <cmath>

#include "reference_cpu/laws/linear_normal.hpp"

namespace grainproof::reference {
namespace {

double compliance(const Elasticity& solid) {
  return (1.0 - solid.poisson_ratio * solid.poisson_ratio) / solid.youngs_modulus;
}

// (2 − ν)/G with G = E/(2 (1 + ν)).
double shear_compliance(const Elasticity& solid) {
  return 2.0 * (2.0 - solid.poisson_ratio) * (1.0 + solid.poisson_ratio) / solid.youngs_modulus;
}

/// dF/dδ = 2 E* a.
double stiffness(double modulus, double circle) {
  return 2.0 * modulus * circle;
}

// Tsuji's α is 2 sqrt(5/6) ζ, with ζ the share of critical damping of a linear contact. A dashpot given in
// N s/m is refused by supports().
double damping_share(const Dissipation& dissipation) {
  if (const auto* given = std::get_if<DampingRatio>(&dissipation)) return 2.0 * given->value;
  return 2.0 * std::sqrt(5.0 / 6.0) * damping_ratio(std::get<Restitution>(dissipation).value);
}

}  // namespace

double HertzContact::damping(double circle, double root_mass) const {
  return damping_share * root_mass * std::sqrt(stiffness(modulus, circle));
}

ShearResponse HertzContact::shear(double circle, double root_mass) const {
  const double shear_stiffness = 8.0 * shear_modulus * circle;
  return {shear_stiffness, damping_share * root_mass * std::sqrt(shear_stiffness)};
}

// t_c = 2.943275 δ/v, where the speed v of the impact is that of 15 m v² = 16 E* a δ².
double HertzContact::contact_time(double circle, double mass) const {
  return 2.943275 * std::sqrt(15.0 * mass / (8.0 * stiffness(modulus, circle)));
}

HertzContact hertz_contact(const HertzNormal& law, const Elasticity& one, const Elasticity& two) {
  return {.modulus = 1.0 / (compliance(one) + compliance(two)),
          .shear_modulus = 1.0 / (shear_compliance(one) + shear_compliance(two)),
          .damping_share = damping_share(law.dissipation)};
}

}  // namespace grainproof::reference
