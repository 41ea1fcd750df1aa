// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "model/vec3.hpp"

namespace grainproof {

/// A sphere as the scene gives it. Mass follows from density and diameter; each engine derives it.
struct Particle {
  std::int64_t id;
  std::int32_t material;                 ///< index into Scene::materials
  bool fixed = false;                    ///< never moves, counts as infinitely heavy in every pair
  double diameter;                       ///< body, m
  double effect_diameter;                ///< reach of cohesion, m; at least `diameter`
  Vec3 position;                         ///< m
  Vec3 velocity;                         ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s; zero unless Scene::rotation
};

}  // namespace grainproof
