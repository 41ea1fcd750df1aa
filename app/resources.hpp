// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace grainproof::app {

/// The folder that holds kernels/ and scenes/: GRAINPROOF_DATA, else the installation's
/// share/grainproof beside the executable's folder, else the nearest folder above the executable.
/// Nothing is compiled in, so an installed or moved tree works. Throws InputRefused.
std::filesystem::path data_root();

/// The scene files of the data folder and the folders in it, by name.
std::vector<std::filesystem::path> known_cases(const std::filesystem::path& root);

/// A scene file by path, or by its name in the data folder. Throws InputRefused with the nearest name.
std::filesystem::path find_case(const std::filesystem::path& root, const std::string& name_or_path);

}  // namespace grainproof::app
