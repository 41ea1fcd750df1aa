// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

#include "input/read_case.hpp"
#include "model/errors.hpp"
#include "tests/input/scene_files.hpp"

/// Whatever a file holds, it is read or refused with a place: no crash, no other exception.
namespace grainproof {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Small limits: a flipped digit may ask for anything, and is to be refused rather than served.
constexpr ReadOptions modest{.force = false, .most_scenes = 10000, .most_particles = 8000};

void expect_read_or_refused(const std::string& text, const std::filesystem::path& name) {
  try {
    read_case_text(text, name, modest);
  } catch (const InputRefused& refused) {
    EXPECT_TRUE(std::string(refused.what()).starts_with(name.string() + ":")) << refused.what();
    EXPECT_NE(std::string(refused.what()).find("; expected "), std::string::npos) << refused.what();
  } catch (const std::exception& other) {
    ADD_FAILURE() << name << " was neither read nor refused: " << other.what() << "\n" << text;
  }
}

class Robustness : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(Robustness, EveryTruncationIsReadOrRefused) {
  const std::string text = text_of(GetParam());
  for (std::size_t length = 0; length <= text.size(); length += 7)
    expect_read_or_refused(text.substr(0, length), GetParam());
}

TEST_P(Robustness, FlippedBytesAreReadOrRefused) {
  const std::string text = text_of(GetParam());
  std::mt19937_64 random(text.size());
  for (int round = 0; round < 300; ++round) {
    std::string flipped = text;
    for (std::size_t flips = 1 + random() % 3; flips > 0; --flips)
      flipped[random() % text.size()] ^= static_cast<char>(1u << random() % 8);
    expect_read_or_refused(flipped, GetParam());
  }
}

TEST_P(Robustness, ExchangedDigitsAreReadOrRefused) {
  const std::string text = text_of(GetParam());
  std::mt19937_64 random(text.size());
  for (int round = 0; round < 300; ++round) {
    std::string changed = text;
    const std::size_t at = text.find_first_of("0123456789", random() % text.size());
    if (at == std::string::npos) continue;
    changed[at] = "0123456789-.e\"[]"[random() % 16];
    expect_read_or_refused(changed, GetParam());
  }
}

TEST_P(Robustness, DroppedLinesAreReadOrRefused) {
  const std::string text = text_of(GetParam());
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    expect_read_or_refused(text.substr(0, begin) + text.substr(end), GetParam());
    begin = end;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Robustness, ::testing::ValuesIn(scene_files()), name_of_file);

TEST(Robustness, NumbersAtTheEdgeOfTheFormatAreReadOrRefused) {
  const std::string text = text_of("scenes/normal_collision_peers.toml");
  for (const std::string number :
       {"1e308", "1e-308", "5e-324", "1e-16", "1.7976931348623157e308", "0.9999999999999999",
        "9223372036854775807", "-9223372036854775808", "1e400"})
    for (const std::string old : {"2000.0", "1e5", "0.8", "0.0166", "-0.5", "0.5", "0.1", "-2.0", "4,"}) {
      std::string changed = text;
      for (std::size_t at = changed.find("= " + old); at != std::string::npos;
           at = changed.find("= " + old, at + 1))
        changed.replace(at + 2, old.size(), number + (old.back() == ',' ? "," : ""));
      expect_read_or_refused(changed, "edge.toml");
    }
}

}  // namespace
}  // namespace grainproof
