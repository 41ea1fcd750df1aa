// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace grainproof::fuzz {

/// Every scene that the project ships, its fills, samples and counts made small so that reading one is quick.
std::vector<std::string> small_scenes(const std::string& folder);

/// Makes scene files out of scene files: numbers at the edges of their ranges, names of other places, values
/// of other types, lines and tables of other scenes, keys that few scenes have, comments, and now and then
/// plain rubbish. The same seed gives the same files everywhere.
class Mutator {
 public:
  Mutator(std::vector<std::string> seeds, std::uint64_t seed);

  std::string next();

 private:
  std::string mutated(const std::string& text);
  std::string with_another_number(const std::string& text);
  std::string with_another_value(const std::string& text);
  std::string with_another_word(const std::string& text);
  std::string with_lines_changed(const std::string& text);
  std::string with_tables_changed(const std::string& text);
  std::string with_a_key_added(const std::string& text);
  std::string with_a_comment(const std::string& text);
  std::string with_bytes_changed(const std::string& text);

  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
  template <class Things>
  const auto& one_of(const Things& things) {
    return things[below(std::size(things))];
  }
  std::string number(const std::string& old);
  std::string value();

  std::mt19937_64 random_;
  std::vector<std::string> seeds_;
  std::vector<std::string> words_;
  std::vector<std::string> lines_;
  std::vector<std::string> tables_;
  std::vector<std::string> values_;
};

}  // namespace grainproof::fuzz
