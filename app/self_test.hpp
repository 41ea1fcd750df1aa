// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "app/progress.hpp"
#include "model/engine.hpp"

namespace grainproof::app {

/// Lets an OpenCL engine's device run a few scenes of one or two spheres, on the small, zoned and dense path,
/// and holds the last frames against their closed forms. Passed once, it is not done again for the same
/// device, driver, precision and text of the kernels: the user's cache remembers. Other engines need none.
/// Throws EngineFailed with what was off.
void require_sound_kernels(const Engine& engine, const std::filesystem::path& data, const std::string& device,
                           Progress& progress);

}  // namespace grainproof::app
