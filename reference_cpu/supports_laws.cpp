// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "reference_cpu/supports.hpp"

namespace grainproof::reference {
namespace {

/// How many particles of one material there are, and how many of them move.
struct Population {
  int all = 0;
  int moving = 0;
};

std::vector<Population> populations(const Scene& scene) {
  std::vector<Population> of(scene.materials.size());
  for (const Particle& particle : scene.particles) {
    ++of[particle.material].all;
    if (!particle.fixed) ++of[particle.material].moving;
  }
  return of;
}

bool can_meet(const std::vector<Population>& of, std::size_t a, std::size_t b) {
  if (a == b) return of[a].all > 1 && of[a].moving > 0;
  return of[a].all > 0 && of[b].all > 0 && of[a].moving + of[b].moving > 0;
}

Support laws_are_given(const Scene& scene) {
  const std::vector<Population> of = populations(scene);
  const auto missing = [&](std::size_t a, std::size_t b) {
    return Support::no("no contact laws between the materials '" + scene.materials[a].name + "' and '" +
                       scene.materials[b].name + "'");
  };
  for (std::size_t a = 0; a < of.size(); ++a) {
    for (std::size_t b = a; b < of.size(); ++b)
      if (can_meet(of, a, b) && !scene.contacts.has(a, b)) return missing(a, b);
    for (const Wall& wall : scene.walls)
      if (of[a].moving > 0 && !scene.contacts.has(a, wall.material)) return missing(a, wall.material);
  }
  return {};
}

Support restitution_is_reachable(const Scene& scene, std::size_t a, std::size_t b) {
  const auto* law = std::get_if<LinearNormal>(&scene.contacts.at(a, b).normal);
  if (!law || !law->no_tension) return {};
  const auto* restitution = std::get_if<Restitution>(&law->dissipation);
  if (restitution && restitution->value == 0.0)
    return Support::no("a contact that never pulls cannot rebound with restitution 0");
  return {};
}

/// What a spring is to be made of must be there.
Support springs_are_given(const Scene& scene, std::size_t a, std::size_t b) {
  const ContactLaws& laws = scene.contacts.at(a, b);
  const bool hertz = std::holds_alternative<HertzNormal>(laws.normal);
  const auto* history = std::get_if<HistoryFriction>(&laws.friction);
  if (!hertz && history && !(history->stiffness > 0.0))
    return Support::no("friction with history on a linear contact needs a tangential stiffness above zero");
  if (!hertz) return {};
  for (const std::size_t material : {a, b})
    if (!scene.materials[material].elasticity)
      return Support::no("a Hertz contact needs the elasticity of '" + scene.materials[material].name + "'");
  const Dissipation& dissipation = std::get<HertzNormal>(laws.normal).dissipation;
  const auto* restitution = std::get_if<Restitution>(&dissipation);
  if (std::holds_alternative<Damping>(dissipation) || (restitution && restitution->value == 0.0))
    return Support::no(
        "a Hertz contact takes its damping from a restitution above 0 or from a damping ratio");
  if (std::holds_alternative<CollisionTimeFriction>(laws.friction) ||
      std::holds_alternative<DampedFriction>(laws.friction))
    return Support::no("this friction needs the contact time of a linear spring, which Hertz contacts lack");
  return {};
}

Support rolling_is_possible(const Scene& scene, std::size_t a, std::size_t b) {
  const ContactLaws& laws = scene.contacts.at(a, b);
  if (std::holds_alternative<NoRolling>(laws.rolling)) return {};
  if (!scene.rotation) return Support::no("rolling resistance needs a scene with rotation");
  if (std::holds_alternative<SpringRolling>(laws.rolling) &&
      !std::holds_alternative<HistoryFriction>(laws.friction))
    return Support::no("a rolling spring takes its stiffness from friction with history, which is missing");
  return {};
}

/// The first refusal among all pairs of materials that have laws.
template <class Check>
Support every_pair(const Scene& scene, Check check) {
  const std::size_t materials = scene.contacts.materials();
  for (std::size_t a = 0; a < materials; ++a)
    for (std::size_t b = a; b < materials; ++b)
      if (scene.contacts.has(a, b))
        if (const Support support = check(scene, a, b); !support) return support;
  return {};
}

}  // namespace

Support laws_supported(const Scene& scene) {
  if (const Support support = laws_are_given(scene); !support) return support;
  for (const auto& check : {springs_are_given, rolling_is_possible, restitution_is_reachable})
    if (const Support support = every_pair(scene, check); !support) return support;
  return {};
}

}  // namespace grainproof::reference
