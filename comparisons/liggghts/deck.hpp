// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "model/engine.hpp"

namespace grainproof::liggghts {

/// Writes the data file and the list of sample steps of one scene into `folder`, and returns the
/// commands that run it and write peers::dump_name(number). Several such texts in a row make one input.
std::string scene_deck(const Scene& scene, const Request& request, const std::filesystem::path& folder,
                       int number);

}  // namespace grainproof::liggghts
