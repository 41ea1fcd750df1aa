// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <numbers>

#include "model/scene.hpp"

namespace grainproof {

/// ρ π d³/6, kg.
inline double mass_of(const Scene& scene, const Particle& particle) {
  const double d = particle.diameter;
  return scene.materials[static_cast<std::size_t>(particle.material)].density * std::numbers::pi * d * d * d /
         6.0;
}

/// 2/5 m r², kg m².
inline double inertia_of(const Scene& scene, const Particle& particle) {
  return 0.1 * mass_of(scene, particle) * particle.diameter * particle.diameter;
}

}  // namespace grainproof
