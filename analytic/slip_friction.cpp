// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/slip_friction.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "analytic/contact_scales.hpp"

namespace grainproof::analytic {

SlipFriction slip_friction(const Encounter& e, double step) {
  const LinearNormal& normal = e.normal_law();
  const double impact_time = boost::math::constants::pi<double>() * std::sqrt(e.mass / normal.stiffness);
  return std::visit(
      Overloaded{
          [](const Frictionless&) { return SlipFriction{}; },
          [](const DynamicFriction& law) { return SlipFriction{law.coefficient}; },
          [&](const StepFriction& law) {
            return SlipFriction{law.coefficient, law.stiffness * step};
          },
          [&](const CollisionTimeFriction& law) {
            return SlipFriction{law.coefficient, law.stiffness * impact_time};
          },
          [&](const DampedFriction& law) {
            return SlipFriction{law.coefficient, law.stiffness * impact_time + damping(normal, e.mass)};
          },
          [](const HistoryFriction&) { return SlipFriction{}; },
      },
      e.laws.friction);
}

}  // namespace grainproof::analytic
