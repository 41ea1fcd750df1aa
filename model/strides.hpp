// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <variant>

#include "model/scene.hpp"

namespace grainproof {

/// Whether a body can pass what it should hit, or a whole period, between two steps and leave no trace. It
/// takes more than a radius a step; a plane or the inside of a cylinder is too deep around it even then.
/// A limit on overlaps of two radii or more, which no scene file may ask for, is for single steps of any
/// length.
inline bool may_leap(const Scene& scene) {
  if (scene.run.overlap_limit >= 2.0) return false;
  const auto thin = [](const Wall& wall) {
    const auto* cylinder = std::get_if<Cylinder>(&wall.shape);
    return std::holds_alternative<Rectangle>(wall.shape) ||
           (cylinder && cylinder->side == Cylinder::Side::outside);
  };
  return scene.particles.size() > 1 || std::any_of(scene.walls.begin(), scene.walls.end(), thin) ||
         scene.domain.periodic(0) || scene.domain.periodic(1) || scene.domain.periodic(2);
}

}  // namespace grainproof
