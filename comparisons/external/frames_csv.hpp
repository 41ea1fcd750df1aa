// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof::external {

/// Reads frames.csv, `time,id,x,y,z,vx,vy,vz` and with rotation `,wx,wy,wz`, rows in any order, and takes the frames at `steps`;
/// others are ignored. A number that is not finite ends the frames and is the outcome. Throws
/// EngineFailed, with the line, for a missing file, other columns, an unknown or doubled particle, and
/// for a frame that is missing or lacks a particle.
Observations read_frames(const std::filesystem::path& file, const Scene& scene,
                         const std::vector<std::int64_t>& steps);

}  // namespace grainproof::external
