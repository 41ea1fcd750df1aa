// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/liggghts/models.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "comparisons/peers/atom_types.hpp"

namespace grainproof::liggghts {

Models models_of(const ContactLaws& laws) {
  Models models;
  const auto* linear = std::get_if<LinearNormal>(&laws.normal);
  const auto* history = std::get_if<HistoryFriction>(&laws.friction);
  models.hertz = linear == nullptr;
  models.no_tension = linear && linear->no_tension;
  models.history = history != nullptr;
  models.friction = !std::holds_alternative<Frictionless>(laws.friction);
  models.tangential_damping = history && history->damping_ratio > 0.0;
  if (std::holds_alternative<ConstantTorqueRolling>(laws.rolling)) models.rolling = Rolling::cdt;
  if (std::holds_alternative<SpringRolling>(laws.rolling)) models.rolling = Rolling::epsd2;
  return models;
}

/// Its dashpot is 2 sqrt(5/6) β sqrt(m k), with β = −ln ε/sqrt(ln² ε + π²).
double restitution_of(const Dissipation& dissipation) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return std::visit(
      Overloaded{[](const Restitution& given) { return given.value; }, [](const Damping&) { return none; },
                 [](const DampingRatio& given) {
                   const double beta = given.value / std::sqrt(5.0 / 6.0);
                   if (beta >= 1.0) return none;
                   return std::exp(-std::numbers::pi * beta / std::sqrt(1.0 - beta * beta));
                 }},
      dissipation);
}

Models models_of(const Scene& scene) {
  Models all;
  for (const ContactLaws& laws : peers::all_laws(scene)) {
    const bool friction = all.friction;
    all = models_of(laws);
    all.friction |= friction;
  }
  return all;
}

}  // namespace grainproof::liggghts
