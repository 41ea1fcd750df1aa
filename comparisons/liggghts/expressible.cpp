// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/liggghts/expressible.hpp"

#include <cmath>
#include <string>
#include <variant>

#include "comparisons/liggghts/models.hpp"
#include "comparisons/liggghts/walls.hpp"
#include "comparisons/peers/atom_types.hpp"
#include "comparisons/peers/expressible.hpp"

namespace grainproof::liggghts {
namespace {

constexpr peers::HistoryVariant own{CoulombLimit::spring, TorqueArm::overlap, SpringTurn::project};
constexpr double least_restitution = 0.05;  // itself refused by LIGGGHTS

Support hertz_support(const Scene& scene, const HertzNormal& law) {
  const double restitution = restitution_of(law.dissipation);
  if (std::isnan(restitution))
    return Support::no("LIGGGHTS' hertz has its dashpot from a restitution, and none is that strong");
  if (restitution <= least_restitution)
    return Support::no("LIGGGHTS' hertz refuses a restitution of 0.05 or less");
  for (const Material& material : scene.materials)
    if (material.elasticity && material.elasticity->poisson_ratio < 0.0)
      return Support::no("LIGGGHTS refuses a Poisson ratio below 0");
  return {};
}

/// One model serves all contacts of a deck.
Support one_model(const Scene& scene) {
  const Models first = models_of(peers::all_laws(scene).front());
  for (const ContactLaws& laws : peers::all_laws(scene)) {
    const Models other = models_of(laws);
    if (other.hertz != first.hertz) return Support::no("LIGGGHTS has one normal model for all contacts");
    if (other.history != first.history)
      return Support::no("LIGGGHTS has one tangential model for all contacts");
    if (other.no_tension != first.no_tension)
      return Support::no("LIGGGHTS limits the force of all contacts or of none");
    if (other.rolling != first.rolling) return Support::no("LIGGGHTS has one rolling model for all contacts");
    if (other.hertz && other.tangential_damping != first.tangential_damping)
      return Support::no("LIGGGHTS' hertz damps all contacts along the tangent or none");
  }
  return {};
}

Support contact_support(const Scene& scene, const ContactLaws& laws) {
  if (std::holds_alternative<LinearCohesion>(laws.cohesion))
    return Support::no("LIGGGHTS has no linear cohesion that reaches beyond the bodies");
  if (const auto* hertz = std::get_if<HertzNormal>(&laws.normal)) {
    if (const Support support = hertz_support(scene, *hertz); !support) return support;
    const auto* history = std::get_if<HistoryFriction>(&laws.friction);
    if (history && history->damping_ratio != 0.0 && history->damping_ratio != 1.0)
      return Support::no("LIGGGHTS' hertz has Mindlin's tangential dashpot or none (damping ratio 1 or 0)");
    if (!history && !std::holds_alternative<Frictionless>(laws.friction))
      return Support::no("with hertz, LIGGGHTS is asked for history friction only");
  }
  if (std::holds_alternative<SpringRolling>(laws.rolling) &&
      !std::holds_alternative<HistoryFriction>(laws.friction))
    return Support::no("LIGGGHTS' epsd2 rolls on the tangential history's stiffness");
  return peers::friction_support(scene, laws, own, "LIGGGHTS");
}

}  // namespace

Support expressible(const Scene& scene, const Request& request) {
  if (const Support support = peers::setting_support(scene, request, "LIGGGHTS"); !support) return support;
  for (const Wall& wall : scene.walls)
    if (const Support support = wall_support(scene, wall); !support) return support;
  for (const ContactLaws& laws : peers::all_laws(scene))
    if (const Support support = contact_support(scene, laws); !support) return support;
  return peers::all_laws(scene).empty() ? Support{} : one_model(scene);
}

std::string variant_of(const Scene& scene) {
  const Models models = models_of(scene);
  std::string variant = models.hertz ? "hertz" : "hooke/stiffness with absolute damping";
  if (models.no_tension) variant += ", limitForce";
  if (models.history)
    variant += "; tangential history: limit on the spring, arm r − δ/2, spring projected";
  else if (models.friction)
    variant += "; friction by tangential no_history, the static part as its damping";
  if (models.rolling != Rolling::off)
    variant += models.rolling == Rolling::cdt ? "; rolling_friction cdt" : "; rolling_friction epsd2";
  if (scene.rotation) variant += "; nve/sphere";
  if (std::holds_alternative<UniformFlow>(scene.flow)) variant += "; drag by viscous and addforce";
  return variant;
}

}  // namespace grainproof::liggghts
