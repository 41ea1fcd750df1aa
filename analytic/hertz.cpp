// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/hertz.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "model/errors.hpp"

namespace grainproof::analytic {

double hertz_modulus(const Elasticity& one, const Elasticity& other) {
  const auto compliance = [](const Elasticity& e) {
    return (1.0 - e.poisson_ratio) * (1.0 + e.poisson_ratio) / e.youngs_modulus;
  };
  return 1.0 / (compliance(one) + compliance(other));
}

double mindlin_modulus(const Elasticity& one, const Elasticity& other) {
  const auto compliance = [](const Elasticity& e) {
    return 2.0 * (2.0 - e.poisson_ratio) * (1.0 + e.poisson_ratio) / e.youngs_modulus;
  };
  return 1.0 / (compliance(one) + compliance(other));
}

double effective_radius(double radius_1, double radius_2) {
  if (std::isinf(radius_1)) return radius_2;
  if (std::isinf(radius_2)) return radius_1;
  return radius_1 * radius_2 / (radius_1 + radius_2);
}

double hertz_damping_ratio(const Dissipation& dissipation) {
  if (const auto* ratio = std::get_if<DampingRatio>(&dissipation)) return ratio->value * std::sqrt(1.2);
  const auto* restitution = std::get_if<Restitution>(&dissipation);
  if (!restitution)
    throw InputRefused("found a Hertz contact with a dashpot; expected its restitution or damping ratio");
  if (!(restitution->value > 0.0 && restitution->value <= 1.0))
    throw InputRefused("found restitution " + std::to_string(restitution->value) +
                       " of a Hertz contact; expected more than 0 and at most 1");
  const double loss = -std::log(restitution->value);
  return loss / std::hypot(boost::math::constants::pi<double>(), loss);
}

HertzPair hertz_pair(const Scene& scene, const std::pair<std::size_t, std::size_t>& materials, double mass,
                     double radius, const HertzNormal& law) {
  const Material& one = scene.materials[materials.first];
  const Material& other = scene.materials[materials.second];
  if (!one.elasticity || !other.elasticity)
    throw InputRefused("found a Hertz contact of " + one.name + " and " + other.name +
                       "; expected youngs_modulus and poisson_ratio of both");
  return {mass, radius, hertz_modulus(*one.elasticity, *other.elasticity),
          mindlin_modulus(*one.elasticity, *other.elasticity), hertz_damping_ratio(law.dissipation)};
}

double HertzPair::force_constant() const {
  return 4.0 / 3.0 * modulus * std::sqrt(radius);
}

double HertzPair::normal_stiffness(double overlap) const {
  return 2.0 * modulus * std::sqrt(radius * overlap);
}

double HertzPair::tangential_stiffness(double overlap) const {
  return 8.0 * shear_modulus * std::sqrt(radius * overlap);
}

double HertzPair::damping(double stiffness) const {
  return 2.0 * damping_ratio * std::sqrt(5.0 / 6.0 * mass * stiffness);
}

double HertzPair::peak_overlap(double speed) const {
  return std::pow(15.0 * mass * speed * speed / (16.0 * modulus * std::sqrt(radius)), 0.4);
}

double HertzPair::duration(double speed) const {
  if (speed == 0.0) return std::numeric_limits<double>::infinity();
  // 2.94392, found in places, is a misprint.
  const double constant =
      2.0 * boost::math::constants::root_pi<double>() * std::tgamma(1.4) / std::tgamma(0.9);
  return constant * peak_overlap(speed) / speed;
}

double HertzPair::resting_overlap(double weight) const {
  return std::pow(weight / force_constant(), 2.0 / 3.0);
}

}  // namespace grainproof::analytic
