// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "app/progress.hpp"
#include "input/read_case.hpp"
#include "model/scene.hpp"

namespace grainproof::app {

struct ChosenScene {
  std::string name;  ///< the case's
  Scene scene;
  std::string step_because = {};  ///< as SweepPoint has it
  bool claims_ledger = false;     ///< what the case claims is read off the ledger
};

/// With the quantities and engines that claims of a file may name.
ReadOptions reading_options(bool force = false);

/// The nth scene (from 1) of the case that a file expands to. With 0 it is the first, and `progress`
/// says so where there are more. Throws InputRefused.
ChosenScene choose_scene(const std::filesystem::path& data, const std::string& name_or_path, int nth,
                         bool force, Progress& progress);

}  // namespace grainproof::app
