// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace grainproof::testing {

struct Ended {
  int code = -1;
  std::string out;
  std::string err;
};

/// Runs the real program with the data of this source tree. `environment` is "NAME=VALUE …".
Ended run_program(const std::string& arguments, const std::string& environment = "");

/// A folder of its own, removed at the end.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  /// Writes a file and returns its path.
  std::string file(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path folder_;
};

std::string text_of(const std::filesystem::path& file);
nlohmann::json json_of(const std::filesystem::path& file);

/// A sphere that falls onto a floor; `changed` replaces what stands for `wanted` in it.
std::string falling_sphere(const std::string& wanted = "", const std::string& changed = "");

/// A sphere that flies out of its open domain at t = 0.45 s.
std::string escaping_sphere();

}  // namespace grainproof::testing
