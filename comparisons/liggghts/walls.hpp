// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/engine.hpp"

namespace grainproof::liggghts {

/// Whether LIGGGHTS has the shape and the motion; `no` says what it lacks.
Support wall_support(const Scene& scene, const Wall& wall);

/// Whether a wall is a mesh of triangles, which wants pairs to be found by bins.
bool is_mesh(const Scene& scene, const Wall& wall);

/// The contact model's name and settings, around what a wall says of itself.
struct WallModel {
  std::string before;
  std::string after;
};

/// Commands of all walls, whose atom types count from 0; a rectangle is two triangles, in a file of `folder`.
std::string wall_commands(const Scene& scene, const std::vector<std::size_t>& types, const WallModel& model,
                          const std::filesystem::path& folder, int number);

}  // namespace grainproof::liggghts
