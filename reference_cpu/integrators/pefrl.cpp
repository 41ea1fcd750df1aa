// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "reference_cpu/integrators/scheme.hpp"

namespace grainproof::reference {
namespace {

// Omelyan, Mryglod and Folk, Comput. Phys. Commun. 146 (2002) 188: the position-extended scheme of Forest and
// Ruth's kind with the least error of fourth order.
constexpr double xi = 0.1786178958448091;
constexpr double lambda = -0.2123418310626054;
constexpr double chi = -0.06626458266981849;

constexpr std::array<SubStep, 4> substeps{
    {{xi, 0.5 - lambda}, {chi, lambda}, {1.0 - 2.0 * (chi + xi), lambda}, {chi, 0.5 - lambda}}};

}  // namespace

void drift(Bodies& bodies, double duration) {
  for (Body& body : bodies.body) body.position += body.velocity * duration;
}

void kick(Bodies& bodies, double duration) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies.body[i].velocity += bodies.acceleration[i] * duration;
  kick_spins(bodies, duration);
}

Scheme pefrl() {
  return {.move = nullptr, .substeps = substeps};
}

}  // namespace grainproof::reference
