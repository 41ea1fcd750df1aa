// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/contact_scales.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "analytic/hertz.hpp"
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
  if (ratio > 1e10) return 2.0 * std::acosh(ratio);  // w is the ratio then, and its square soon has no number
  const double w = std::sqrt((ratio - 1.0) * (ratio + 1.0));
  return 2.0 * ratio / w * std::asinh(w);
}

/// The ratio whose loss is −ln ε. The loss grows from 0 without bound, so there is one root, and as 2 arcosh
/// s.
double no_tension_ratio(double loss) {
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::bracket_and_solve_root(
      [loss](double ratio) { return no_tension_loss(ratio) - loss; },
      loss < 2.0 ? loss / pi : std::cosh(0.5 * loss), 2.0, true,
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
  if (const auto* given = std::get_if<DampingRatio>(&law.dissipation))
    return 2.0 * given->value * std::sqrt(mass * law.stiffness);
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

namespace {

/// How fast a wall comes at a particle; turning within itself, it does not.
double speed_of(const WallMotion& motion) {
  return std::visit(Overloaded{[](const Translating& translating) { return translating.velocity.norm(); },
                               [](const Vibrating& vibrating) {
                                 return 2.0 * pi * vibrating.frequency * vibrating.amplitude.norm();
                               },
                               [](const auto&) { return 0.0; }},
                    motion);
}

}  // namespace

ClosingSpeeds::ClosingSpeeds(const Scene& scene, std::optional<double> impact_speed)
    : of_pairs(0.0), on_walls(0.0) {
  double second = 0.0;
  for (const Particle& particle : scene.particles) {
    const double speed = particle.fixed ? 0.0 : particle.velocity.norm();
    second = std::max(second, std::min(speed, on_walls));
    on_walls = std::max(on_walls, speed);
  }
  of_pairs = on_walls + second;
  double fastest_wall = 0.0;
  for (const Wall& wall : scene.walls) fastest_wall = std::max(fastest_wall, speed_of(wall.motion));
  on_walls += fastest_wall;
  if (impact_speed) of_pairs = on_walls = *impact_speed;
}

ContactScale scale_of(const Scene& scene, const PossibleContact& contact, const ClosingSpeeds& speeds) {
  return std::visit(Overloaded{[&](const LinearNormal& law) {
                                 const double eta = damping(law, contact.mass);
                                 return ContactScale{contact_duration(law.stiffness, eta, contact.mass),
                                                     contact.mass,
                                                     law.stiffness,
                                                     eta,
                                                     0.0,
                                                     contact.between};
                               },
                               [&](const HertzNormal& law) {
                                 const HertzPair pair =
                                     hertz_pair(scene, contact.materials, contact.mass, contact.radius, law);
                                 const double speed = contact.on_wall ? speeds.on_walls : speeds.of_pairs;
                                 const double peak = pair.peak_overlap(speed),
                                              k = pair.normal_stiffness(peak);
                                 return ContactScale{pair.duration(speed), contact.mass, k,
                                                     pair.damping(k),      peak,         contact.between};
                               }},
                    contact.laws->normal);
}

std::optional<ContactScale> shortest_contact(const Scene& scene, std::optional<double> impact_speed) {
  const ClosingSpeeds speeds(scene, impact_speed);
  std::optional<ContactScale> shortest;
  for (const PossibleContact& contact : possible_contacts(scene)) {
    const ContactScale scale = scale_of(scene, contact, speeds);
    if (!shortest || scale.duration < shortest->duration) shortest = scale;
  }
  return shortest;
}

bool lacks_impact_speed(const Scene& scene) {
  if (ClosingSpeeds(scene).on_walls > 0.0) return false;
  for (const PossibleContact& contact : possible_contacts(scene))
    if (std::holds_alternative<HertzNormal>(contact.laws->normal)) return true;
  return false;
}

}  // namespace grainproof::analytic
