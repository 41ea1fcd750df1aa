// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/laws.hpp"
#include "model/vec3.hpp"

namespace grainproof::reference {

/// Spring and dashpot against slip, as they are at one overlap.
struct ShearResponse {
  double stiffness;  ///< k_t, N/m
  double damping;    ///< η_t, N s/m
};

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
  Vec3 turned(const Vec3& displacement, const Vec3& normal) const;

  /// On body 2. Cuts ζ back where the contact slides.
  Vec3 force(Vec3& displacement, const Vec3& slip, double normal_force, const ShearResponse& shear) const;
};

TangentialSpring tangential_spring(const FrictionLaw& law);

/// Share of the overlap by which a body's torque arm is shorter than its radius.
double arm_shortening(const FrictionLaw& law);

}  // namespace grainproof::reference
