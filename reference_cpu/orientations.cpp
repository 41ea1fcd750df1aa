// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/orientations.hpp"

#include <cmath>

namespace grainproof::reference {
namespace {

/// The turn by a rotation vector (rad), by half its angle. sin(x)/x → 1 where the angle vanishes.
Quaternion turn(const Vec3& rotation) {
  const double half = 0.5 * rotation.norm();
  const double share = half == 0.0 ? 0.5 : 0.5 * std::sin(half) / half;
  Quaternion quaternion;
  quaternion.w() = std::cos(half);
  quaternion.vec() = share * rotation;
  return quaternion;
}

/// q + ½ (0, rotation) q, as printed: its length grows (E14).
Quaternion stepped(const Quaternion& orientation, const Vec3& rotation) {
  Quaternion spin;
  spin.w() = 0.0;
  spin.vec() = 0.5 * rotation;
  return Quaternion(orientation.coeffs() + (spin * orientation).coeffs());
}

}  // namespace

void turn_bodies(OrientationUpdate update, Bodies& bodies, double step, double lag) {
  for (std::size_t i = 0; i < bodies.orientation.size(); ++i) {
    const Vec3 held = bodies.spin[i].angular_velocity - bodies.angular_acceleration[i] * (lag * step);
    Quaternion& orientation = bodies.orientation[i];
    orientation = update == OrientationUpdate::exponential ? turn(held * step) * orientation
                                                           : stepped(orientation, held * step);
  }
}

}  // namespace grainproof::reference
