// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/walls.hpp"

namespace grainproof {

/// A wall as a point in space sees it at one time.
struct Facing {
  double distance;        ///< m, from the surface; negative behind a plane or a cylinder
  Vec3 normal;            ///< from the surface to the point
  Vec3 surface_velocity;  ///< m/s, of the surface's nearest point
};

/// At a time in s, with the wall where its motion has taken it.
Facing facing(const Wall& wall, const Vec3& x, double time);

/// Time for a point that moves with `velocity` against the wall at rest to come within `reach` of it in a
/// straight line; negative where it is within already, infinite if it never does.
double time_to_reach(const Wall& wall, const Vec3& x, double time, const Vec3& velocity, double reach);

}  // namespace grainproof
