// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/engine.hpp"

namespace grainproof::liggghts {

/// Whether LIGGGHTS can express a scene, and what it cannot.
Support expressible(const Scene& scene, const Request& request);

/// Which of LIGGGHTS' laws stand in for the scene's, for Provenance::variant.
std::string variant_of(const Scene& scene);

}  // namespace grainproof::liggghts
