// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/fuzz/mutator.hpp"

namespace grainproof::fuzz {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Counts of what a scene is made of, not physics.
std::string made_small(const std::string& text) {
  static const std::regex count("\\b(count|phases|samples|seeds|orientation) = [0-9]+");
  static const std::regex counts("counts = \\[ ?[0-9]+, [0-9]+, [0-9]+ ?\\]");
  static const std::regex frames("(frames|steps) = [0-9]{2,}");
  std::string small = std::regex_replace(text, count, "$1 = 3");
  small = std::regex_replace(small, counts, "counts = [2, 2, 1]");
  return std::regex_replace(small, frames, "$1 = 7");
}

}  // namespace

std::vector<std::string> small_scenes(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> scenes;
  for (const auto& file : files) scenes.push_back(made_small(text_of(file)));
  return scenes;
}

}  // namespace grainproof::fuzz
