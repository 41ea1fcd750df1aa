// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace grainproof::opencl {

/// The files one after the other, with #line directives so that a compiler names the real file and line.
/// Throws EngineFailed for a file that cannot be read.
std::string assembled_source(const std::filesystem::path& folder, const std::vector<std::string>& files);

}  // namespace grainproof::opencl
