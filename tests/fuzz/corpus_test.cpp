// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Inputs that were once found to crash, to hang or to be accepted as nonsense.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/fuzz/one_input.hpp"

namespace grainproof::fuzz {
namespace {

std::vector<std::filesystem::path> corpus() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator("tests/fuzz/corpus"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Corpus : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(Corpus, IsReadSoundlyOrRefused) {
  std::ostringstream text;
  text << std::ifstream(GetParam(), std::ios::binary).rdbuf();
  EXPECT_EQ(judge(text.str(), true).complaint, "");
}

INSTANTIATE_TEST_SUITE_P(Found, Corpus, ::testing::ValuesIn(corpus()),
                         [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace grainproof::fuzz
