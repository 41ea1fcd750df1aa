// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/tangential_spring.hpp"

#include <cmath>

namespace grainproof::reference {
namespace {

/// The limit is on the spring; while it slides there is no dashpot.
Vec3 limited_spring(Vec3& displacement, const Vec3& slip, double limit, const ShearResponse& shear) {
  const double pull = shear.stiffness * displacement.norm();
  if (pull <= limit) return -shear.stiffness * displacement - shear.damping * slip;
  displacement *= limit / pull;
  return -shear.stiffness * displacement;
}

/// The limit is on both together, and ζ is what makes them add up to it.
Vec3 limited_sum(Vec3& displacement, const Vec3& slip, double limit, const ShearResponse& shear) {
  const Vec3 dashpot = shear.damping * slip;
  const Vec3 sum = shear.stiffness * displacement + dashpot;
  const double magnitude = sum.norm();
  if (magnitude <= limit) return -sum;
  const Vec3 cut = sum * (limit / magnitude);
  displacement = (cut - dashpot) / shear.stiffness;
  return -cut;
}

}  // namespace

Vec3 TangentialSpring::turned(const Vec3& displacement, const Vec3& normal) const {
  Vec3 in_plane = displacement - displacement.dot(normal) * normal;
  if (turn == SpringTurn::project) return in_plane;
  const double length = in_plane.norm();
  if (length > 0.0) in_plane *= displacement.norm() / length;
  return in_plane;
}

Vec3 TangentialSpring::force(Vec3& displacement, const Vec3& slip, double normal_force,
                             const ShearResponse& shear) const {
  const double most = coefficient * std::abs(normal_force);
  return limit == CoulombLimit::spring ? limited_spring(displacement, slip, most, shear)
                                       : limited_sum(displacement, slip, most, shear);
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
