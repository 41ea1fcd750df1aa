// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/tangential_spring.hpp"

namespace grainproof::reference {

TangentialSpring tangential_spring(const FrictionLaw& law) {
  const auto* given = std::get_if<HistoryFriction>(&law);
  if (!given) return {};
  return {.coefficient = given->coefficient,
          .stiffness = given->stiffness,
          .damping_ratio = given->damping_ratio,
          .limit = given->limit,
          .turn = given->turn,
          .keeps_force = given->memory == SpringMemory::force};
}

double arm_shortening(const FrictionLaw& law) {
  const auto* given = std::get_if<HistoryFriction>(&law);
  return given && given->arm == TorqueArm::overlap ? 0.5 : 0.0;
}

}  // namespace grainproof::reference
