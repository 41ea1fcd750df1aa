// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::opencl::testing {

/// Lively scenes of unequal spheres, one for every stage and law that a kernel can be built with.
std::vector<std::string> varied_scene_names();

/// `layers` of 3 x 3 spheres. Throws std::out_of_range for a name that is not in the list.
Scene varied_scene(const std::string& name, int layers = 4);

inline constexpr int varied_steps = 300;

/// Between the sites of the spheres, m.
inline constexpr double lattice_spacing = 0.14;

}  // namespace grainproof::opencl::testing
