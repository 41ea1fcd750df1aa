// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/case.hpp"

namespace grainproof {

struct ReadOptions {
  bool force = false;                             ///< admits steps above the stability limit
  std::size_t most_scenes = 20000;                ///< a sweep that expands to more is refused
  std::size_t most_particles = 20'000'000;        ///< over all scenes of the case
  std::vector<std::string_view> quantities = {};  ///< that a claim may be about; none given: any
  std::vector<std::string_view> engines = {};  ///< that it may name, without what follows a colon; likewise
};

/// Reads a scene file (docs/scene.md) and expands its sweep. Throws InputRefused with
/// "FILE:LINE:COLUMN: found …; expected …". Where the case itself expects to be refused, the message
/// stands in Case::refused instead.
Case read_case(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from text. `name` stands in messages and gives the case its name; files that the text
/// refers to are looked for beside it.
Case read_case_text(const std::string& text, const std::filesystem::path& name,
                    const ReadOptions& options = {});

}  // namespace grainproof
