// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "model/engine.hpp"

namespace grainproof::lammps {

/// Whether LAMMPS has the shape, the motion and the side of it that particles are on; `no` says what it
/// lacks.
Support wall_support(const Scene& scene, const Wall& wall);

/// Region that a turning cylinder is, with the variable that turns it; empty for other walls.
std::string wall_region(const Scene& scene, std::size_t wall);

/// Style, contact, shape and motion, as a fix takes them after its group.
std::string wall_fix(const Scene& scene, std::size_t wall, const std::string& style);

}  // namespace grainproof::lammps
