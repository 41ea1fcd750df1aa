// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/linear_normal.hpp"

#include <cmath>
#include <numbers>

namespace grainproof::reference {
namespace {

/// Root of a rising function, by bisection down to neighbouring numbers.
template <class Function>
double root_between(double low, double high, Function function) {
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (function(middle) < 0.0 ? low : high) = middle;
  }
}

double ratio_for(const LinearNormal& law, double restitution) {
  return law.no_tension ? damping_ratio_without_tension(restitution) : damping_ratio(restitution);
}

}  // namespace

double damping_ratio(double restitution) {
  if (restitution == 0.0) return 1.0;
  const double log = std::log(restitution);
  return -log / std::sqrt(std::numbers::pi * std::numbers::pi + log * log);
}

// The clamped contact ends where k δ + η δ' = 0. With ζ = cos c the rebound is exp(−2 c/tan c) up to
// critical damping, c in (0, π/2]; with ζ = cosh b it is exp(−2 b/tanh b) beyond, so every
// restitution above zero is reached, and e⁻² at critical damping.
double damping_ratio_without_tension(double restitution) {
  const double wanted = -std::log(restitution);
  if (wanted == 0.0) return 0.0;
  if (wanted < 2.0) {
    const auto missing = [wanted](double c) { return wanted - 2.0 * c / std::tan(c); };
    return std::cos(root_between(0.0, 0.5 * std::numbers::pi, missing));
  }
  const auto excess = [wanted](double b) { return 2.0 * b / std::tanh(b) - wanted; };
  return std::cosh(root_between(0.0, wanted, excess));
}

SpringDashpot spring_dashpot(const LinearNormal& law) {
  SpringDashpot contact{.stiffness = law.stiffness, .no_tension = law.no_tension};
  std::visit(Overloaded{[&](const Restitution& given) {
                          contact.damping_per_root_mass =
                              2.0 * ratio_for(law, given.value) * std::sqrt(law.stiffness);
                        },
                        [&](const Damping& given) { contact.damping = given.value; },
                        [&](const DampingRatio& given) {
                          contact.damping_per_root_mass = 2.0 * given.value * std::sqrt(law.stiffness);
                        }},
             law.dissipation);
  return contact;
}

double SpringDashpot::contact_time(double mass) const {
  const double decay = damping_for(std::sqrt(mass)) / (2.0 * mass);
  const double square = stiffness / mass;
  const double damped_square = square - decay * decay;
  return std::numbers::pi / std::sqrt(damped_square > 0.0 ? damped_square : square);
}

}  // namespace grainproof::reference
