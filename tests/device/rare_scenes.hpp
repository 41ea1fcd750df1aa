// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::opencl::testing {

/// Scenes for the kernels that none of the varied scenes needs: what takes seconds to compile is not run by
/// every test.
std::vector<std::string> rare_scene_names(bool small_only = false);

/// One of those, or of the varied ones. Throws std::out_of_range for any other name.
Scene any_scene(const std::string& name, int layers);

}  // namespace grainproof::opencl::testing
