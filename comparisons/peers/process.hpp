// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grainproof {

/// A private folder below the system's temporary one, removed with all it holds.
class TemporaryFolder {
 public:
  /// Throws EngineFailed where no folder can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Where a program is, by PATH as the shell would look for it.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Runs a program in `folder` with both its outputs in `output` and waits. Returns the exit status,
/// 128 + signal where it was killed, 127 where it could not be started.
int run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                const std::filesystem::path& output);

/// Last lines of a text file; empty where there is none.
std::string last_lines(const std::filesystem::path& file, int count);

}  // namespace grainproof
