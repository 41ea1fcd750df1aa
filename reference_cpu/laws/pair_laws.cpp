// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/pair_laws.hpp"

namespace grainproof::reference {

PairLaws resolve(const ContactLaws& laws, double step) {
  PairLaws resolved;
  resolved.normal = std::visit(Overloaded{[](const LinearNormal& law) { return spring_dashpot(law); },
                                          [](const HertzNormal&) { return SpringDashpot{}; }},
                               laws.normal);
  resolved.friction = slip_friction(laws.friction, resolved.normal.stiffness, step);
  resolved.cohesion =
      std::visit(Overloaded{[](const NoCohesion&) { return EffectSpring{}; },
                            [](const LinearCohesion& law) { return EffectSpring{law.stiffness}; }},
                 laws.cohesion);
  return resolved;
}

LawTable::LawTable(const ContactTable& contacts, double step)
    : materials_(contacts.materials()), laws_(materials_ * materials_) {
  for (std::size_t a = 0; a < materials_; ++a)
    for (std::size_t b = 0; b < materials_; ++b)
      if (contacts.has(a, b)) laws_[a * materials_ + b] = resolve(contacts.at(a, b), step);
}

}  // namespace grainproof::reference
