// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/contact_scales.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "analytic/possible_contacts.hpp"
#include "model/errors.hpp"

namespace grainproof::analytic {
namespace {

constexpr double pi = boost::math::constants::pi<double>();

/// Damping ratio s = η/(2 sqrt(m k)) → the exponent −ln ε of a contact that never pulls (linear.8).
double no_tension_loss(double ratio) {
  if (ratio < 1.0) {
    const double w = std::sqrt((1.0 - ratio) * (1.0 + ratio));
    return ratio / w * std::atan2(2.0 * ratio * w, (ratio - w) * (ratio + w));
  }
  if (ratio == 1.0) return 2.0;
  const double w = std::sqrt((ratio - 1.0) * (ratio + 1.0));
  return 2.0 * ratio / w * std::asinh(w);
}

/// The ratio whose loss is −ln ε. The loss grows from 0 without bound, so there is one root.
double no_tension_ratio(double loss) {
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::bracket_and_solve_root(
      [loss](double ratio) { return no_tension_loss(ratio) - loss; }, loss / pi, 2.0, true,
      boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

double damping_ratio(double restitution, bool no_tension) {
  if (!(restitution >= 0.0 && restitution <= 1.0))
    throw InputRefused("found restitution " + std::to_string(restitution) + "; expected 0 to 1");
  if (restitution == 1.0) return 0.0;
  if (no_tension && restitution == 0.0)
    throw InputRefused(
        "found restitution 0 with no_tension; expected more than 0, since a contact that "
        "never pulls always rebounds");
  const double loss = -std::log(restitution);
  if (no_tension) return no_tension_ratio(loss);
  return restitution == 0.0 ? 1.0 : loss / std::hypot(pi, loss);
}

}  // namespace

double sphere_mass(double density, double diameter) {
  return density * pi / 6.0 * diameter * diameter * diameter;
}

double effective_mass(double mass_1, double mass_2) {
  if (std::isinf(mass_1)) return mass_2;
  if (std::isinf(mass_2)) return mass_1;
  return mass_1 * mass_2 / (mass_1 + mass_2);
}

double damping(const LinearNormal& law, double mass) {
  if (const auto* given = std::get_if<Damping>(&law.dissipation)) return given->value;
  const double ratio = damping_ratio(std::get<Restitution>(law.dissipation).value, law.no_tension);
  return 2.0 * ratio * std::sqrt(mass * law.stiffness);
}

double restitution_of(double damping, double stiffness, double mass) {
  const double ratio = damping / (2.0 * std::sqrt(mass * stiffness));
  if (ratio >= 1.0) return 0.0;
  return std::exp(-pi * ratio / std::sqrt((1.0 - ratio) * (1.0 + ratio)));
}

double no_tension_restitution_of(double damping, double stiffness, double mass) {
  return std::exp(-no_tension_loss(damping / (2.0 * std::sqrt(mass * stiffness))));
}

double contact_duration(double stiffness, double damping, double mass) {
  const double ratio = damping / (2.0 * std::sqrt(mass * stiffness));
  const double undamped = pi * std::sqrt(mass / stiffness);
  return ratio >= 1.0 ? undamped : undamped / std::sqrt((1.0 - ratio) * (1.0 + ratio));
}

std::optional<ContactScale> shortest_contact(const Scene& scene) {
  std::optional<ContactScale> shortest;
  for (const PossibleContact& contact : possible_contacts(scene)) {
    const auto& normal = std::get<LinearNormal>(contact.laws->normal);
    const double eta = damping(normal, contact.mass);
    const double duration = contact_duration(normal.stiffness, eta, contact.mass);
    if (!shortest || duration < shortest->duration)
      shortest = {duration, contact.mass, normal.stiffness, eta, contact.between};
  }
  return shortest;
}

}  // namespace grainproof::analytic
