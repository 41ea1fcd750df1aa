// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "model/laws.hpp"
#include "model/vec3.hpp"

namespace grainproof::reference {

/// Spring and dashpot against slip, as they are at one overlap.
struct ShearResponse {
  double stiffness;  ///< k_t, N/m
  double damping;    ///< η_t, N s/m
};

/// Of a trial force beyond the limit `most` what is left at the end of a step that began with the force
/// `before`: of second order where the force turns (integrators.36). All on the same body and in one plane,
/// N.
Vec3 returned_to_limit(const Vec3& before, const Vec3& trial, double most);

/// Friction with a memory (docs/laws/history.md): ζ, the slip since the bodies met.
struct TangentialSpring {
  double coefficient = 0.0;    ///< μ; zero is no such friction
  double stiffness = 0.0;      ///< N/m; a Hertz contact has its own
  double damping_ratio = 0.0;  ///< η_t over the η of the normal contact
  CoulombLimit limit = CoulombLimit::spring_and_dashpot;
  SpringTurn turn = SpringTurn::project;
  bool keeps_force = false;  ///< k_t ζ while k_t grows; else always ζ

  bool present() const { return coefficient != 0.0; }

  /// ζ laid into the tangent plane as it is now.
  Vec3 turned(const Vec3& displacement, const Vec3& normal) const {
    Vec3 in_plane = displacement - displacement.dot(normal) * normal;
    if (turn == SpringTurn::project) return in_plane;
    const double length = in_plane.norm();
    if (length > 0.0) in_plane *= displacement.norm() / length;
    return in_plane;
  }

  /// On body 2. Cuts ζ back where the contact slides.
  Vec3 force(Vec3& displacement, const Vec3& slip, double normal_force, const ShearResponse& shear) const {
    const double most = coefficient * std::abs(normal_force);
    return limit == CoulombLimit::spring ? limited_spring(displacement, slip, most, shear)
                                         : limited_sum(displacement, slip, most, shear);
  }

  /// As force(), at the end of a step (s) through which the bodies have touched and in which `moved` has
  /// stretched ζ. Where the contact sticks it is the same.
  Vec3 force_over_step(Vec3& displacement, const Vec3& moved, const Vec3& slip, double normal_force,
                       const ShearResponse& shear, double step) const {
    const double most = coefficient * std::abs(normal_force);
    const bool alone = limit == CoulombLimit::spring;
    const Vec3 pull = shear.stiffness * displacement, dashpot = shear.damping * slip;
    const Vec3 sum = pull + dashpot;
    if ((alone ? pull : sum).squaredNorm() <= most * most) return -sum;
    Vec3 before = shear.stiffness * (displacement - moved);
    if (!alone) before += shear.damping * ((2.0 / step) * moved - slip);
    const Vec3 left = returned_to_limit(before, alone ? pull : sum, most);
    displacement = (alone ? left : (left - dashpot).eval()) / shear.stiffness;
    return -left;
  }

 private:
  /// The limit is on the spring; while it slides there is no dashpot.
  static Vec3 limited_spring(Vec3& displacement, const Vec3& slip, double most, const ShearResponse& shear) {
    const Vec3 pull = shear.stiffness * displacement;
    const double square = pull.squaredNorm();
    if (square <= most * most) return -pull - shear.damping * slip;
    const double share = most / std::sqrt(square);
    displacement *= share;
    return -pull * share;
  }

  /// The limit is on both together, and ζ is what makes them add up to it.
  static Vec3 limited_sum(Vec3& displacement, const Vec3& slip, double most, const ShearResponse& shear) {
    const Vec3 dashpot = shear.damping * slip;
    const Vec3 sum = shear.stiffness * displacement + dashpot;
    const double square = sum.squaredNorm();
    if (square <= most * most) return -sum;
    const Vec3 cut = sum * (most / std::sqrt(square));
    displacement = (cut - dashpot) / shear.stiffness;
    return -cut;
  }
};

TangentialSpring tangential_spring(const FrictionLaw& law);

/// Share of the overlap by which a body's torque arm is shorter than its radius.
double arm_shortening(const FrictionLaw& law);

}  // namespace grainproof::reference
