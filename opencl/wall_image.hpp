// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "opencl/near_walls.hpp"
#include "opencl/scene_image.hpp"

namespace grainproof::opencl {

/// Walls as a device takes them.
struct WallBytes {
  Bytes planes, rectangles, cylinders;
};

WallBytes wall_bytes(const NearWalls& walls, const Scene& scene, Precision precision);

/// Where the moving walls stand and how fast they go at steps first … last, a row a step. Worked out from n
/// Δt in double, so that single precision loses nothing however long a run is. One row where none moves.
Bytes stand_table(const NearWalls& walls, const Scene& scene, std::int64_t first, std::int64_t last,
                  Precision precision);

/// Farthest that a wall comes from where it is drawn while the scene runs, m.
double farthest_shift(const WallMotion& motion, double end);

}  // namespace grainproof::opencl
