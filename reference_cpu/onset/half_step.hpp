// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Geometry>

#include "reference_cpu/bodies.hpp"
#include "reference_cpu/encounter.hpp"

/// How body 2 moves over body 1 in the middle of the step that led here.
namespace grainproof::reference {

/// Centres or the wall's surface, m/s.
inline Vec3 half_step_approach(const Bodies& bodies, const Encounter& meet) {
  const Vec3& of_first = meet.with_wall() ? meet.wall_velocity : bodies.half_velocity[meet.first];
  return bodies.half_velocity[meet.second] - of_first;
}

/// As AnyTouch::sweep(), m/s.
inline Vec3 half_step_sweep(const Bodies& bodies, const Encounter& meet, const TorqueArms& arms) {
  Vec3 sweep = arms.second * bodies.half_spin[meet.second];
  if (!meet.with_wall()) sweep += arms.first * bodies.half_spin[meet.first];
  return sweep;
}

/// Where they touch, m/s.
template <bool turning>
Vec3 half_step_velocity(const Bodies& bodies, const Encounter& meet, const TorqueArms& arms) {
  Vec3 velocity = half_step_approach(bodies, meet);
  if constexpr (turning) velocity -= half_step_sweep(bodies, meet, arms).cross(meet.normal);
  return velocity;
}

/// By what a tangential spring is stretched in a whole step, m. Spheres roll round each other, so the normal
/// in the middle of the step, n − c w, is the one that tells slip from approach; the slip there, laid into
/// the plane of n, is multiplied out here (integrators.12).
template <bool turning>
Vec3 moved_in_step(const Bodies& bodies, const Encounter& meet, const TorqueArms& arms, double step) {
  const Vec3 velocity = half_step_approach(bodies, meet);
  const double separating = velocity.dot(meet.normal);
  Vec3 along = velocity - separating * meet.normal;  // w
  Vec3 sweep = Vec3::Zero();
  if constexpr (turning) sweep = half_step_sweep(bodies, meet, arms);
  if (!meet.with_wall()) {
    const double touching = bodies.body[meet.first].radius + bodies.body[meet.second].radius;
    const double c = 0.5 * step / (touching - meet.overlap);
    if constexpr (turning) sweep += (c * sweep.dot(meet.normal)) * along;
    along *= 1.0 + c * (separating - c * along.squaredNorm());
  }
  if constexpr (turning) along -= sweep.cross(meet.normal);
  return along * step;
}

/// Where they touch by the normal in the middle of the step: the approach along it, and the slip laid into
/// the plane of now, m/s.
template <bool turning>
Vec3 half_step_velocity_by_then(const Bodies& bodies, const Encounter& meet, const TorqueArms& arms,
                                double step) {
  const Vec3 velocity = half_step_approach(bodies, meet);
  double separating = velocity.dot(meet.normal);
  if (!meet.with_wall()) {
    const double touching = bodies.body[meet.first].radius + bodies.body[meet.second].radius;
    const double c = 0.5 * step / (touching - meet.overlap);
    separating -= c * (velocity - separating * meet.normal).squaredNorm();
  }
  return moved_in_step<turning>(bodies, meet, arms, step) / step + separating * meet.normal;
}

/// What parallel transport of a spring has over laying it into the plane of now: (ζ·n) c w (integrators.35).
inline Vec3 carried_round(const Bodies& bodies, const Encounter& meet, const Vec3& spring, double step) {
  const Vec3 velocity = half_step_approach(bodies, meet);
  const Vec3 along = velocity - velocity.dot(meet.normal) * meet.normal;
  const double touching = bodies.body[meet.first].radius + bodies.body[meet.second].radius;
  const double c = 0.5 * step / (touching - meet.overlap);
  return (spring.dot(meet.normal) * c) * along;
}

}  // namespace grainproof::reference
