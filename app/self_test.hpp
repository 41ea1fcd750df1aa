// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "app/progress.hpp"
#include "model/engine.hpp"

namespace grainproof::app {

/// A run that is to begin.
struct RunAhead {
  const Engine& engine;
  const Scene& scene;
  const Request& request;
};

/// Lets an OpenCL engine's device run a few scenes of one or two spheres, with the integrator and on the path
/// that the run ahead takes, and holds the last frames against their closed forms and against the reference.
/// Passed once, it is not done again for the same device, driver, precision, integrator, path and text of the
/// kernels: the user's cache remembers. Other engines need none. Throws EngineFailed with what was off.
void require_sound_kernels(const RunAhead& run, const std::filesystem::path& data, const std::string& device,
                           Progress& progress);

}  // namespace grainproof::app
