// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/origin.hpp"

namespace grainproof::reference {

Vec3 origin_of(const Scene& scene) {
  Vec3 origin = Vec3::Zero();
  if (std::holds_alternative<TaylorGreenFlow>(scene.flow)) return origin;
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.lower[axis] > 0.0 || scene.domain.upper[axis] < 0.0)
      origin[axis] = scene.domain.lower[axis];
  return origin;
}

Scene counted_from(const Vec3& origin, Scene scene) {
  if (origin.isZero(0.0)) return scene;
  scene.domain.lower -= origin;
  scene.domain.upper -= origin;
  for (Particle& particle : scene.particles) particle.position -= origin;
  for (Wall& wall : scene.walls)
    std::visit(Overloaded{[&](Rectangle& rectangle) {
                            rectangle.lower -= origin;
                            rectangle.upper -= origin;
                          },
                          [&](auto& shape) { shape.point -= origin; }},
               wall.shape);
  if (auto* central = std::get_if<CentralGravity>(&scene.gravity)) central->centre -= origin;
  return scene;
}

Vec3 place_of(const Vec3& counted, const Vec3& origin, const Domain& counted_domain) {
  Vec3 place = counted + origin;
  for (int axis = 0; axis < 3; ++axis)
    if (origin[axis] != 0.0 && counted_domain.periodic(axis) &&
        place[axis] >= counted_domain.upper[axis] + origin[axis])
      place[axis] = origin[axis] + counted_domain.lower[axis];
  return place;
}

}  // namespace grainproof::reference
