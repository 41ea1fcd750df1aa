// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string_view>
#include <system_error>

namespace grainproof::report {

/// A full disk must not pass for a result: throws std::filesystem::filesystem_error when a write failed.
inline void require_written(const std::ostream& stream, const std::filesystem::path& path) {
  if (!stream)
    throw std::filesystem::filesystem_error("cannot write", path, std::make_error_code(std::errc::io_error));
}

/// Replaces the file, making its folder where that is missing.
inline void write_file(const std::filesystem::path& path, std::string_view text) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  std::ofstream stream(path, std::ios::binary);
  stream << text << std::flush;
  require_written(stream, path);
}

}  // namespace grainproof::report
