// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "tests/fuzz/constraints.hpp"

namespace grainproof::fuzz {
namespace {

bool positive(double x) {
  return std::isfinite(x) && x > 0.0;
}
bool not_negative(double x) {
  return std::isfinite(x) && x >= 0.0;
}

bool sound(const Dissipation& dissipation) {
  return std::visit(Overloaded{[](const Restitution& e) { return e.value >= 0.0 && e.value <= 1.0; },
                               [](const Damping& d) { return not_negative(d.value); },
                               [](const DampingRatio& d) { return not_negative(d.value); }},
                    dissipation);
}

bool is_zero(const Dissipation& dissipation) {
  const auto* restitution = std::get_if<Restitution>(&dissipation);
  return restitution && restitution->value == 0.0;
}

bool sound(const LinearNormal& law) {
  return positive(law.stiffness) && sound(law.dissipation) && !(law.no_tension && is_zero(law.dissipation));
}

bool sound(const HertzNormal& law) {
  return sound(law.dissipation) && !is_zero(law.dissipation) &&
         !std::holds_alternative<Damping>(law.dissipation);
}

bool sound(const FrictionLaw& friction, bool hertz) {
  return std::visit(Overloaded{[](const Frictionless&) { return true; },
                               [](const DynamicFriction& law) { return not_negative(law.coefficient); },
                               [&](const HistoryFriction& law) {
                                 return not_negative(law.coefficient) && not_negative(law.damping_ratio) &&
                                        (hertz ? law.stiffness == 0.0 : positive(law.stiffness));
                               },
                               [](const StepFriction& law) {
                                 return not_negative(law.coefficient) && positive(law.stiffness);
                               },
                               [&](const auto& law) {
                                 return !hertz && not_negative(law.coefficient) && positive(law.stiffness);
                               }},
                    friction);
}

bool sound(const RollingLaw& rolling, const ContactLaws& laws, bool rotation) {
  return std::visit(
      Overloaded{[](const NoRolling&) { return true; },
                 [&](const ConstantTorqueRolling& law) { return rotation && not_negative(law.coefficient); },
                 [&](const SpringRolling& law) {
                   return rotation && not_negative(law.coefficient) &&
                          std::holds_alternative<HistoryFriction>(laws.friction);
                 }},
      rolling);
}

bool sound(const ContactLaws& laws, const Scene& scene, std::size_t a, std::size_t b) {
  const bool hertz = std::holds_alternative<HertzNormal>(laws.normal);
  const auto* cohesion = std::get_if<LinearCohesion>(&laws.cohesion);
  return std::visit([](const auto& law) { return sound(law); }, laws.normal) && sound(laws.friction, hertz) &&
         sound(laws.rolling, laws, scene.rotation) && (!cohesion || positive(cohesion->stiffness)) &&
         (!hertz || (scene.materials[a].elasticity && scene.materials[b].elasticity));
}

std::string broken_material(const Material& material) {
  if (!positive(material.density)) return "density above 0";
  if (!material.elasticity) return "";
  const auto [modulus, ratio] = *material.elasticity;
  return positive(modulus) && ratio > -1.0 && ratio <= 0.5 ? "" : "elasticity in its range";
}

bool can_meet(const Scene& scene, std::size_t a, std::size_t b) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& one = scene.particles[i];
    if (one.fixed || one.material != static_cast<std::int32_t>(a)) continue;
    for (const Wall& wall : scene.walls)
      if (wall.material == static_cast<std::int32_t>(b)) return true;
    for (std::size_t j = 0; j < scene.particles.size(); ++j)
      if (i != j && scene.particles[j].material == static_cast<std::int32_t>(b)) return true;
  }
  return false;
}

}  // namespace

std::string broken_law(const Scene& scene) {
  const std::size_t materials = scene.materials.size();
  if (scene.contacts.materials() != materials) return "a table of contacts for all materials";
  for (const Material& material : scene.materials)
    if (std::string broken = broken_material(material); !broken.empty()) return broken;
  for (std::size_t a = 0; a < materials; ++a)
    for (std::size_t b = 0; b < materials; ++b) {
      if (scene.contacts.has(a, b) != scene.contacts.has(b, a)) return "contacts the same both ways";
      if (scene.contacts.has(a, b) && !sound(scene.contacts.at(a, b), scene, a, b))
        return "a sound contact law";
      if (!scene.contacts.has(a, b) && can_meet(scene, a, b)) return "laws for all that can meet";
    }
  return "";
}

}  // namespace grainproof::fuzz
