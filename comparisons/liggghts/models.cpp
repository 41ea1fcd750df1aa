// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/liggghts/models.hpp"

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
  return models;
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
