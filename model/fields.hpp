// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <variant>

#include "model/vec3.hpp"

/// What acts on a particle without a contact. Equations in docs/laws/fields.md.
namespace grainproof {

struct ConstantGravity {
  Vec3 acceleration;  ///< m/s²
};

/// magnitude · (sin θ, −cos θ, 0), θ = (t / time_scale)² as in the gravity-shift box, where
/// the source has θ = t²/4, so time_scale = 2 s.
struct RotatingGravity {
  double magnitude;   ///< m/s²
  double time_scale;  ///< s
};

/// Constant magnitude towards a point; zero at the point itself.
struct CentralGravity {
  double magnitude;  ///< m/s²
  Vec3 centre;       ///< m
};

using Gravity = std::variant<ConstantGravity, RotatingGravity, CentralGravity>;

struct NoFlow {};

/// A uniform stream; zero velocity is a still fluid. Viscosity in Pa s.
struct UniformFlow {
  double viscosity;
  Vec3 velocity;
};

/// Andrews 6.1-6.3: amplitude A in m/s, wave number a in 1/m, vortices of size π/a.
struct TaylorGreenFlow {
  double viscosity;
  double amplitude;
  double wave_number;
};

using Flow = std::variant<NoFlow, UniformFlow, TaylorGreenFlow>;

}  // namespace grainproof
