// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "model/engine.hpp"

namespace grainproof::lammps {

/// Whether LAMMPS can express a scene, and what it cannot.
Support expressible(const Scene& scene, const Request& request);

/// Which of LAMMPS' laws stand in for the scene's, for Provenance::variant.
std::string variant_of(const Scene& scene);

}  // namespace grainproof::lammps
