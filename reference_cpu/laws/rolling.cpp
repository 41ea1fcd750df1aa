// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/rolling.hpp"

namespace grainproof::reference {
namespace {

Vec3 in_plane(const Vec3& vector, const Vec3& normal) {
  return vector - vector.dot(normal) * normal;
}

}  // namespace

RollingResistance rolling_resistance(const RollingLaw& law) {
  return std::visit(
      Overloaded{[](const NoRolling&) { return RollingResistance{}; },
                 [](const ConstantTorqueRolling& given) { return RollingResistance{given.coefficient}; },
                 [](const SpringRolling& given) {
                   return RollingResistance{given.coefficient, true};
                 }},
      law);
}

Vec3 constant_torque(double most, const Vec3& spin, const Vec3& normal) {
  const double rate = spin.norm();
  if (rate == 0.0) return Vec3::Zero();
  return in_plane(spin * (-most / rate), normal);
}

Vec3 wound_torque(const Vec3& kept, double most, double stiffness, const Vec3& spin, const Vec3& normal,
                  double elapsed) {
  const Vec3 torque = kept - in_plane(spin, normal) * (stiffness * elapsed);
  const double magnitude = torque.norm();
  return magnitude > most ? (torque * (most / magnitude)).eval() : torque;
}

}  // namespace grainproof::reference
