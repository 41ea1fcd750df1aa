// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <variant>

#include "model/vec3.hpp"

namespace grainproof {

/// Half-space: solid where (x − point)·normal < 0. `normal` has unit length and points to the particles.
struct Plane {
  Vec3 point;
  Vec3 normal;
};

/// Flat axis-aligned rectangle, solid from both sides, with edges and corners.
/// Exactly one component of upper − lower is zero.
struct Rectangle {
  Vec3 lower;
  Vec3 upper;
};

using WallShape = std::variant<Plane, Rectangle>;

/// A fixed wall. The faces of the domain that are walls stand in Scene::walls as planes too.
struct Wall {
  std::string name;
  std::int32_t material;
  WallShape shape;
};

}  // namespace grainproof
