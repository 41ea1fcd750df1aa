// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/peers/expressible.hpp"

#include <variant>

#include "comparisons/peers/atom_types.hpp"

namespace grainproof::peers {
namespace {

constexpr std::size_t most_types = 32;  // parameters are a table over pairs of types

Support integrator_support(Integrator integrator, const std::string& program) {
  const bool same = integrator == Integrator::velocity_verlet || integrator == Integrator::leapfrog_verlet;
  return same ? Support{}
              : Support::no(program + " integrates by velocity Verlet, not " +
                            std::string(name_of(integrator)) +
                            "; a scene that says integrator = \"velocity_verlet\" can be compared");
}

Support gravity_support(const Gravity& gravity, const std::string& program) {
  return std::visit(Overloaded{[](const ConstantGravity&) { return Support{}; },
                               [&](const RotatingGravity&) {
                                 return Support::no(program + " has no gravity that rotates with t²");
                               },
                               [&](const CentralGravity&) {
                                 return Support::no(program + " has no gravity towards a point");
                               }},
                    gravity);
}

Support flow_support(const Flow& flow, const std::string& program) {
  return std::visit(
      Overloaded{[](const NoFlow&) { return Support{}; }, [](const UniformFlow&) { return Support{}; },
                 [&](const TaylorGreenFlow&) { return Support::no(program + " has no Taylor-Green flow"); }},
      flow);
}

/// What is kept matters where the stiffness changes.
Support memory_support(const ContactLaws& laws, const HistoryFriction& law, const std::string& program) {
  const bool same =
      law.memory == SpringMemory::displacement || std::holds_alternative<LinearNormal>(laws.normal);
  return same ? Support{}
              : Support::no(program + " keeps the displacement of the spring while a Hertz contact unloads");
}

Support start_support(const Scene& scene, const std::string& program) {
  if (!scene.remembered.empty())
    return Support::no(program + " starts every contact anew, without what it remembers");
  if (scene.orientation != OrientationUpdate::none)
    return Support::no(program + " keeps no orientation of spheres");
  return {};
}

Support history_support(const Scene& scene, const HistoryFriction& law, const HistoryVariant& own,
                        const std::string& program) {
  if (law.turn != own.turn)
    return Support::no(program + " turns the tangential spring by " +
                       (own.turn == SpringTurn::project ? "project" : "project_and_rescale") + " only");
  if (law.limit != own.limit && law.damping_ratio > 0.0)
    return Support::no(program + " puts the Coulomb limit on " +
                       (own.limit == CoulombLimit::spring ? "the spring alone" : "spring and dashpot"));
  if (law.arm != own.arm && scene.rotation)
    return Support::no(
        program + " turns spheres at " +
        (own.arm == TorqueArm::radius ? "their radius" : "their radius less half the overlap"));
  return {};
}

}  // namespace

Support setting_support(const Scene& scene, const Request& request, const std::string& program) {
  if (request.ledger) return Support::no(program + " keeps no energy and impulse ledger");
  for (const Support& support :
       {integrator_support(scene.run.integrator, program), gravity_support(scene.gravity, program),
        flow_support(scene.flow, program), start_support(scene, program)})
    if (!support) return support;
  if (atom_types(scene).types.size() > most_types)
    return Support::no("more than " + std::to_string(most_types) + " kinds of particles and walls");
  return {};
}

Support friction_support(const Scene& scene, const ContactLaws& laws, const HistoryVariant& own,
                         const std::string& program) {
  if (const auto* law = std::get_if<HistoryFriction>(&laws.friction)) {
    const Support memory = memory_support(laws, *law, program);
    return memory ? history_support(scene, *law, own, program) : memory;
  }
  if (scene.rotation && own.arm != TorqueArm::radius && !std::holds_alternative<Frictionless>(laws.friction))
    return Support::no(program + " turns spheres at their radius less half the overlap");
  return {};
}

}  // namespace grainproof::peers
