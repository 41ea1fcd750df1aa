// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/peers/atom_types.hpp"

#include <cmath>
#include <numbers>
#include <variant>

namespace grainproof::peers {
namespace {

constexpr double always_sliding = 1e30;  // N s/m; any slip above 1e-30 m/s reaches the Coulomb limit

double mass_of(const Scene& scene, const Particle& particle) {
  const double radius = 0.5 * particle.diameter;
  return scene.materials[static_cast<std::size_t>(particle.material)].density * 4.0 / 3.0 * std::numbers::pi *
         radius * radius * radius;
}

bool alike(const AtomType& a, const AtomType& b) {
  return a.material == b.material && a.diameter == b.diameter && a.moves == b.moves;
}

std::size_t index_of(std::vector<AtomType>& types, const AtomType& wanted) {
  for (std::size_t i = 0; i < types.size(); ++i)
    if (alike(types[i], wanted)) return i;
  types.push_back(wanted);
  return types.size() - 1;
}

double effective_mass(const AtomType& a, const AtomType& b) {
  if (a.moves && b.moves) return a.mass * b.mass / (a.mass + b.mass);
  return a.moves ? a.mass : b.mass;
}

/// Restitution of a contact that never pulls, for the damping ratio ζ = η/(2 sqrt(m k)): it ends
/// where the force vanishes, where the velocity is exactly e^(−β t) times the first.
double restitution_without_tension(double ratio) {
  if (ratio < 1.0) {
    const double omega = std::sqrt(1.0 - ratio * ratio);
    return std::exp(-ratio / omega * std::atan2(2.0 * ratio * omega, ratio * ratio - omega * omega));
  }
  const double rate = std::sqrt(ratio * ratio - 1.0);
  return rate == 0.0 ? std::exp(-2.0) : std::exp(-2.0 * ratio / rate * std::atanh(rate / ratio));
}

double ratio_without_tension(double restitution) {
  double low = 0.0;
  double high = 1.0;
  while (restitution_without_tension(high) > restitution) high *= 2.0;
  for (int halvings = 0; halvings < 200; ++halvings) {
    const double middle = 0.5 * (low + high);
    (restitution_without_tension(middle) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double damping_ratio(double restitution, bool no_tension) {
  if (restitution == 1.0) return 0.0;
  if (no_tension) return ratio_without_tension(restitution);
  if (restitution == 0.0) return 1.0;
  const double logarithm = std::log(restitution);
  return -logarithm / std::hypot(std::numbers::pi, logarithm);
}

double damping_of(const LinearNormal& law, double mass) {
  return std::visit(
      Overloaded{
          [](const Damping& given) { return given.value; },
          [&](const DampingRatio& given) { return 2.0 * given.value * std::sqrt(mass * law.stiffness); },
          [&](const Restitution& given) {
            return 2.0 * damping_ratio(given.value, law.no_tension) * std::sqrt(mass * law.stiffness);
          }},
      law.dissipation);
}

void add_friction(const FrictionLaw& friction, double step, PairParameters& pair) {
  const double collision_time = std::numbers::pi * std::sqrt(pair.mass / pair.stiffness);
  const auto slides = [&](double coefficient, double tangential_damping) {
    pair.friction = coefficient;
    pair.tangential_damping = tangential_damping;
  };
  std::visit(Overloaded{[](const Frictionless&) {},
                        [&](const DynamicFriction& law) { slides(law.coefficient, always_sliding); },
                        [&](const StepFriction& law) { slides(law.coefficient, law.stiffness * step); },
                        [&](const CollisionTimeFriction& law) {
                          slides(law.coefficient, law.stiffness * collision_time);
                        },
                        [&](const DampedFriction& law) {
                          slides(law.coefficient, law.stiffness * collision_time + pair.damping);
                        },
                        [&](const HistoryFriction& law) {
                          slides(law.coefficient, law.damping_ratio * pair.damping);
                          pair.tangential_stiffness = law.stiffness;
                          pair.history = true;
                        }},
             friction);
}

}  // namespace

TypeTable atom_types(const Scene& scene) {
  TypeTable table;
  for (const Particle& particle : scene.particles)
    table.of_particle.push_back(index_of(
        table.types, {particle.material, mass_of(scene, particle), particle.diameter, !particle.fixed}));
  for (const Wall& wall : scene.walls)
    table.of_wall.push_back(index_of(table.types, {wall.material, 0.0, 0.0, false}));
  return table;
}

const ContactLaws* laws_between(const Scene& scene, const AtomType& a, const AtomType& b) {
  const auto first = static_cast<std::size_t>(a.material);
  const auto second = static_cast<std::size_t>(b.material);
  if ((!a.moves && !b.moves) || !scene.contacts.has(first, second)) return nullptr;
  return &scene.contacts.at(first, second);
}

PairParameters pair_parameters(const Scene& scene, const AtomType& a, const AtomType& b) {
  const ContactLaws* laws = laws_between(scene, a, b);
  const auto* normal = laws ? std::get_if<LinearNormal>(&laws->normal) : nullptr;
  if (!normal) return {};
  PairParameters pair;
  pair.mass = effective_mass(a, b);
  pair.stiffness = pair.tangential_stiffness = normal->stiffness;
  pair.damping = damping_of(*normal, pair.mass);
  pair.no_tension = normal->no_tension;
  add_friction(laws->friction, scene.run.step, pair);
  return pair;
}

std::vector<ContactLaws> all_laws(const Scene& scene) {
  std::vector<ContactLaws> laws;
  for (std::size_t a = 0; a < scene.contacts.materials(); ++a)
    for (std::size_t b = 0; b <= a; ++b)
      if (scene.contacts.has(a, b)) laws.push_back(scene.contacts.at(a, b));
  return laws;
}

}  // namespace grainproof::peers
