// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/pair_laws.hpp"

#include <algorithm>

namespace grainproof::reference {
namespace {

bool has_only_springs(const PairLaws& laws) {
  const TangentialSpring& spring = laws.spring;
  const bool plain = spring.present() && spring.turn == SpringTurn::project && !spring.keeps_force;
  return plain && !laws.hertz.present() && !laws.rolling.present();
}

}  // namespace

PairLaws resolve(const Scene& scene, std::size_t a, std::size_t b) {
  const ContactLaws& laws = scene.contacts.at(a, b);
  PairLaws resolved;
  std::visit(Overloaded{[&](const LinearNormal& law) { resolved.normal = spring_dashpot(law); },
                        [&](const HertzNormal& law) {
                          resolved.hertz = hertz_contact(law, scene.materials[a].elasticity.value(),
                                                         scene.materials[b].elasticity.value());
                        }},
             laws.normal);
  resolved.friction = slip_friction(laws.friction, resolved.normal.stiffness, scene.run.step);
  resolved.spring = tangential_spring(laws.friction);
  resolved.rolling = rolling_resistance(laws.rolling);
  resolved.arm_shortening = arm_shortening(laws.friction);
  std::visit(Overloaded{[](const NoCohesion&) {},
                        [&](const LinearCohesion& law) { resolved.cohesion.stiffness = law.stiffness; }},
             laws.cohesion);
  resolved.only_springs = has_only_springs(resolved);
  return resolved;
}

LawTable::LawTable(const Scene& scene)
    : materials_(scene.contacts.materials()), laws_(materials_ * materials_) {
  for (std::size_t a = 0; a < materials_; ++a)
    for (std::size_t b = 0; b < materials_; ++b)
      if (scene.contacts.has(a, b)) laws_[a * materials_ + b] = resolve(scene, a, b);
}

bool LawTable::all_simple() const {
  return std::ranges::all_of(laws_, &PairLaws::simple);
}

}  // namespace grainproof::reference
