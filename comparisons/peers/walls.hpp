// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "model/engine.hpp"

/// What both programs need to know about a wall to say it in their own words.
namespace grainproof::peers {

/// A plane across an axis, or a rectangle that spans its whole cross-section of the domain.
struct AxisPlane {
  int axis;
  double at;
};

/// Empty for any other wall.
std::optional<AxisPlane> axis_plane(const Wall& wall, const Domain& domain);

/// A speed along one of the axes, m/s.
struct AxisSpeed {
  int axis;
  double speed;
};

/// Empty where the vector has another direction or none.
std::optional<AxisSpeed> axis_speed(const Vec3& velocity);

/// Axis of a cylinder that lies along one.
std::optional<int> lengthwise(const Cylinder& cylinder);

/// A wall is solid from both sides there: particles must start on its open side.
Support open_side_support(const Scene& scene, const Wall& wall, const std::string& program);

}  // namespace grainproof::peers
