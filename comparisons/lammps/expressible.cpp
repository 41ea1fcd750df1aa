// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/lammps/expressible.hpp"

#include <variant>

#include "comparisons/lammps/walls.hpp"
#include "comparisons/peers/atom_types.hpp"
#include "comparisons/peers/expressible.hpp"

namespace grainproof::lammps {
namespace {

constexpr peers::HistoryVariant own{CoulombLimit::spring_and_dashpot, TorqueArm::radius, SpringTurn::project};

bool is_elastic(const HertzNormal& normal) {
  return std::visit(Overloaded{[](const Restitution& given) { return given.value == 1.0; },
                               [](const auto& given) { return given.value == 0.0; }},
                    normal.dissipation);
}

Support hertz_support(const HertzNormal& normal, const FrictionLaw& friction) {
  if (!is_elastic(normal))
    return Support::no(
        "the dashpot of LAMMPS' gran/hertz grows with the root of the overlap, not its fourth "
        "root, so only elastic contacts agree");
  if (!std::holds_alternative<Frictionless>(friction) && !std::holds_alternative<HistoryFriction>(friction))
    return Support::no("LAMMPS' gran/hertz has history friction only");
  return {};
}

Support contact_support(const Scene& scene, const ContactLaws& laws) {
  if (std::holds_alternative<LinearCohesion>(laws.cohesion))
    return Support::no("LAMMPS' gran styles have no cohesion that reaches beyond the bodies");
  if (!std::holds_alternative<NoRolling>(laws.rolling))
    return Support::no("LAMMPS' gran styles have no rolling resistance");
  if (const auto* hertz = std::get_if<HertzNormal>(&laws.normal))
    if (const Support support = hertz_support(*hertz, laws.friction); !support) return support;
  return peers::friction_support(scene, laws, own, "LAMMPS");
}

template <class Alternative, class Member>
bool any(const Scene& scene, Member member) {
  for (const ContactLaws& laws : peers::all_laws(scene))
    if (std::holds_alternative<Alternative>(laws.*member)) return true;
  return false;
}

}  // namespace

Support expressible(const Scene& scene, const Request& request) {
  if (const Support support = peers::setting_support(scene, request, "LAMMPS"); !support) return support;
  for (const Wall& wall : scene.walls)
    if (const Support support = wall_support(scene, wall); !support) return support;
  for (const ContactLaws& laws : peers::all_laws(scene))
    if (const Support support = contact_support(scene, laws); !support) return support;
  return {};
}

std::string variant_of(const Scene& scene) {
  std::string variant = any<HertzNormal>(scene, &ContactLaws::normal) ? "gran/hertz/history" : "gran/hooke";
  if (any<HistoryFriction>(scene, &ContactLaws::friction))
    variant += "; history: limit on spring and dashpot, arm r, spring projected";
  else if (any<DynamicFriction>(scene, &ContactLaws::friction) ||
           any<StepFriction>(scene, &ContactLaws::friction) ||
           any<CollisionTimeFriction>(scene, &ContactLaws::friction) ||
           any<DampedFriction>(scene, &ContactLaws::friction))
    variant += "; friction without history, the static part as its damping";
  if (scene.rotation) variant += "; nve/sphere";
  if (std::holds_alternative<UniformFlow>(scene.flow)) variant += "; drag by viscous and addforce";
  return variant;
}

}  // namespace grainproof::lammps
