// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/liggghts/expressible.hpp"

#include <string>
#include <variant>

#include "comparisons/liggghts/atom_types.hpp"

namespace grainproof::liggghts {
namespace {

constexpr std::size_t most_types = 32;  // parameters are a table over pairs of types

Support integrator_support(Integrator integrator) {
  const bool same = integrator == Integrator::velocity_verlet || integrator == Integrator::leapfrog_verlet;
  return same
             ? Support{}
             : Support::no("LIGGGHTS integrates by velocity Verlet, not " + std::string(name_of(integrator)));
}

Support gravity_support(const Gravity& gravity) {
  return std::visit(
      Overloaded{
          [](const ConstantGravity&) { return Support{}; },
          [](const RotatingGravity&) { return Support::no("LIGGGHTS has no gravity that rotates with t²"); },
          [](const CentralGravity&) { return Support::no("LIGGGHTS has no gravity towards a point"); }},
      gravity);
}

Support flow_support(const Flow& flow) {
  return std::visit(
      Overloaded{[](const NoFlow&) { return Support{}; }, [](const UniformFlow&) { return Support{}; },
                 [](const TaylorGreenFlow&) { return Support::no("LIGGGHTS has no Taylor-Green flow"); }},
      flow);
}

Support contact_support(const Scene& scene) {
  const std::size_t count = scene.contacts.materials();
  bool tension = false;
  bool no_tension = false;
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      if (!scene.contacts.has(a, b)) continue;
      const ContactLaws& laws = scene.contacts.at(a, b);
      if (std::holds_alternative<LinearCohesion>(laws.cohesion))
        return Support::no("LIGGGHTS has no linear cohesion that reaches beyond the bodies");
      const auto* normal = std::get_if<LinearNormal>(&laws.normal);
      if (!normal) return Support::no("Hertz contacts are not written for LIGGGHTS yet");
      if (std::holds_alternative<HistoryFriction>(laws.friction))
        return Support::no("history friction is not written for LIGGGHTS yet");
      (normal->no_tension ? no_tension : tension) = true;
    }
  return tension && no_tension ? Support::no("LIGGGHTS limits the force of all contacts or of none")
                               : Support{};
}

/// A rectangle is a plane where it spans its whole cross-section of the domain.
bool spans_domain(const Rectangle& rectangle, const Domain& domain) {
  int across = 0;
  (rectangle.upper - rectangle.lower).minCoeff(&across);
  for (int axis = 0; axis < 3; ++axis)
    if (axis != across &&
        (rectangle.lower[axis] > domain.lower[axis] || rectangle.upper[axis] < domain.upper[axis]))
      return false;
  return true;
}

Support wall_support(const Scene& scene) {
  for (const Wall& wall : scene.walls) {
    if (const auto* rectangle = std::get_if<Rectangle>(&wall.shape)) {
      if (!spans_domain(*rectangle, scene.domain)) return Support::no("LIGGGHTS' flat walls have no edges");
      continue;
    }
    const auto& plane = std::get<Plane>(wall.shape);
    if (plane.normal.cwiseAbs().maxCoeff() != 1.0)
      return Support::no("LIGGGHTS' flat walls lie along the axes");
    for (const Particle& particle : scene.particles)
      if ((particle.position - plane.point).dot(plane.normal) < 0.0)
        return Support::no("a particle starts behind a wall, which LIGGGHTS has solid from both sides");
  }
  return {};
}

}  // namespace

Support expressible(const Scene& scene, const Request& request) {
  if (request.ledger) return Support::no("LIGGGHTS keeps no energy and impulse ledger");
  if (scene.rotation) return Support::no("rotation is not written for LIGGGHTS yet");
  for (const Support& support : {integrator_support(scene.run.integrator), gravity_support(scene.gravity),
                                 flow_support(scene.flow), contact_support(scene), wall_support(scene)})
    if (!support) return support;
  if (atom_types(scene).types.size() > most_types)
    return Support::no("more than " + std::to_string(most_types) + " kinds of particles and walls");
  return {};
}

std::string variant_of(const Scene& scene) {
  std::string variant = "hooke/stiffness with absolute damping";
  if (atom_types(scene).no_tension) variant += ", limitForce";
  bool friction = false;
  for (std::size_t a = 0; a < scene.contacts.materials(); ++a)
    for (std::size_t b = 0; b <= a; ++b)
      friction |=
          scene.contacts.has(a, b) && !std::holds_alternative<Frictionless>(scene.contacts.at(a, b).friction);
  if (friction) variant += "; friction by tangential no_history, the static part as its damping";
  if (std::holds_alternative<UniformFlow>(scene.flow)) variant += "; drag by viscous and addforce";
  return variant;
}

}  // namespace grainproof::liggghts
