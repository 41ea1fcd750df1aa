// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof::liggghts {

/// Frames of a dump with the columns id x y z vx vy vz, put into the scene's order and into the
/// domain along periodic axes. A particle that is gone or not a number ends them, and is the outcome.
/// Throws EngineFailed where the file is missing or cut off, or a frame of `steps` is not there.
Observations read_dump(const std::filesystem::path& file, const Scene& scene,
                       const std::vector<std::int64_t>& steps);

}  // namespace grainproof::liggghts
