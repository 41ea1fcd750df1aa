// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::bench {

inline constexpr int tile_side = 20;       ///< diameters: a tile of 10 000
inline constexpr int small_tile_side = 6;  ///< a tile of 900

struct SettledTile {
  double side;  ///< m
  std::vector<Vec3> positions;
};

/// A bed without particles: floor, periodic sides, weight.
Scene empty_bed(double along_x, double along_y);

/// Of the bed, `side` diameters square and periodic: read from `cache`, or let fall and come to rest by the
/// reference engine, and written there. The same on every machine.
SettledTile settled_tile(int side, const std::filesystem::path& cache);

}  // namespace grainproof::bench
