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

/// Infinite round cylinder about the line through `point` along `axis`, of unit length.
struct Cylinder {
  enum class Side { inside, outside };  ///< where the particles are

  Vec3 point;
  Vec3 axis;
  double radius;  ///< m
  Side side;
};

/// Flat axis-aligned rectangle, solid from both sides, with edges and corners.
/// Exactly one component of upper − lower is zero.
struct Rectangle {
  Vec3 lower;
  Vec3 upper;
};

using WallShape = std::variant<Plane, Cylinder, Rectangle>;

struct Still {};

struct Translating {
  Vec3 velocity;  ///< m/s
};

/// Turns within itself: a plane about its normal through `point`, a cylinder about its own axis. The surface
/// stays where it is and moves along itself with ω × (x − reference point).
struct Rotating {
  double rate;  ///< rad/s, right-handed about the plane's normal or the cylinder's axis
};

/// Shifted by amplitude · (sin(2π frequency t + phase) − sin(phase)), so that it starts where it is drawn.
struct Vibrating {
  Vec3 amplitude;    ///< m
  double frequency;  ///< Hz
  double phase;      ///< rad
};

using WallMotion = std::variant<Still, Translating, Rotating, Vibrating>;

/// Counts as infinitely heavy. The faces of the domain that are walls stand in Scene::walls as planes too,
/// and are still. Reference point: `point` of a plane or a cylinder, `lower` of a rectangle, shifted by
/// motion.
struct Wall {
  std::string name;
  std::int32_t material;
  WallShape shape;
  WallMotion motion = Still{};
};

}  // namespace grainproof
