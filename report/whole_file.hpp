// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

/// Files that are there as a whole or not at all, and that show whether they are still whole.
namespace grainproof::report {

/// Bytes in front of a sealed file, with its kind, its layout, its length and a hash of what follows.
inline constexpr std::size_t seal_bytes = 512;

/// Lets `fill` write the file beside `path`, leaving `seal_bytes` in front; then seals it, puts it on the
/// disk and gives it its name. Throws std::filesystem::filesystem_error.
void write_sealed(const std::filesystem::path& path, const std::string& kind, int layout,
                  const std::function<void(const std::filesystem::path&)>& fill);

/// Throws InputRefused where the file is not there, of another kind or layout, truncated or damaged.
void require_sealed(const std::filesystem::path& path, const std::string& kind, int layout);

}  // namespace grainproof::report
