// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/tangential_spring.hpp"

namespace grainproof::reference {

// Cutting the trial back once, and once in each of two half steps; the error of the two is as 2 to 1.
Vec3 returned_to_limit(const Vec3& before, const Vec3& trial, double most) {
  const Vec3 once = trial.normalized();
  const Vec3 middle = 0.5 * (before + trial);
  const double length = middle.norm(), limit = 0.5 * (before.norm() + most);
  if (length <= limit) return most * once;
  const Vec3 rest = trial - (1.0 - limit / length) * middle;
  const double beyond = rest.norm();
  if (beyond == 0.0) return most * once;  // no limit at all
  const Vec3 extrapolated = (2.0 / beyond) * rest - once;
  return (most / extrapolated.norm()) * extrapolated;
}

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
