// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/friction.hpp"

#include <limits>
#include <numbers>

namespace grainproof::reference {
namespace {

/// k_f π sqrt(m/k_e) over sqrt(m): the slip of one undamped contact time.
double contact_time_slope(double friction_stiffness, double normal_stiffness) {
  return friction_stiffness * std::numbers::pi / std::sqrt(normal_stiffness);
}

}  // namespace

SlipFriction slip_friction(const FrictionLaw& law, double normal_stiffness, double step) {
  return std::visit(
      Overloaded{[](const Frictionless&) { return SlipFriction{}; },
                 [](const HistoryFriction&) { return SlipFriction{}; },
                 [](const DynamicFriction& given) {
                   return SlipFriction{given.coefficient, std::numeric_limits<double>::infinity()};
                 },
                 [&](const StepFriction& given) {
                   return SlipFriction{given.coefficient, given.stiffness * step};
                 },
                 [&](const CollisionTimeFriction& given) {
                   return SlipFriction{given.coefficient, 0.0,
                                       contact_time_slope(given.stiffness, normal_stiffness)};
                 },
                 [&](const DampedFriction& given) {
                   return SlipFriction{given.coefficient, 0.0,
                                       contact_time_slope(given.stiffness, normal_stiffness), true};
                 }},
      law);
}

}  // namespace grainproof::reference
