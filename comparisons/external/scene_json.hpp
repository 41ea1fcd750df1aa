// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include "model/engine.hpp"

namespace grainproof::external {

/// The scene and what is asked for, as docs/external.md describes it; every number in full precision.
nlohmann::json scene_json(const Scene& scene, const Request& request);

}  // namespace grainproof::external
