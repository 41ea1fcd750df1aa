// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/gravity.hpp"

#include <cmath>

#include "model/laws.hpp"

namespace grainproof::reference {

GravityField::GravityField(const Gravity& gravity, double time) {
  std::visit(Overloaded{[&](const ConstantGravity& constant) { uniform_ = constant.acceleration; },
                        [&](const RotatingGravity& rotating) {
                          const double turns = time / rotating.time_scale;
                          const double angle = turns * turns;
                          uniform_ = rotating.magnitude * Vec3(std::sin(angle), -std::cos(angle), 0.0);
                        },
                        [&](const CentralGravity& central) { centre_ = central; }},
             gravity);
}

Vec3 GravityField::towards_centre(const Vec3& position) const {
  const Vec3 inward = centre_->centre - position;
  const double distance = inward.norm();
  if (distance == 0.0) return Vec3::Zero();
  return inward * (centre_->magnitude / distance);
}

}  // namespace grainproof::reference
