// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof::peers {

/// Frames of a dump with the columns id x y z vx vy vz and, with rotation, three of angular velocity, put
/// into the scene's order and into the domain along periodic axes. A particle that is gone or not a number
/// ends them, and is the outcome. Throws EngineFailed, in the name of `program`, where the file is missing or
/// cut off, or a frame of `steps` is not there.
Observations read_dump(const std::filesystem::path& file, const Scene& scene,
                       const std::vector<std::int64_t>& steps, const std::string& program);

}  // namespace grainproof::peers
