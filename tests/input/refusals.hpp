// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "model/errors.hpp"
#include "tests/input/example.hpp"

namespace grainproof {

/// One mistake made in the example, and what the reader must say about it.
struct Mistake {
  const char* name;
  const char* there;
  const char* instead;
  const char* found;
  const char* expected;
  const char* on_line_of = nullptr;  ///< a passage on the line that is to be named; else `instead`
};

inline std::ostream& operator<<(std::ostream& out, const Mistake& mistake) {
  return out << mistake.name;
}

inline std::string name_of_mistake(const ::testing::TestParamInfo<Mistake>& info) {
  return info.param.name;
}

inline std::string refusal_of(const std::string& text, const ReadOptions& options = {}) {
  try {
    read_text(text, options);
  } catch (const InputRefused& refused) {
    return refused.what();
  }
  return "";
}

class Refusal : public ::testing::TestWithParam<Mistake> {};

inline void expect_refused(const Mistake& mistake, const std::string& correct = example) {
  const std::string text = with(correct, mistake.there, mistake.instead);
  const std::string message = refusal_of(text);
  const std::string passage = mistake.on_line_of ? mistake.on_line_of : mistake.instead;
  const std::string place = "scene.toml:" + std::to_string(line_of(text, passage)) + ":";
  EXPECT_TRUE(message.starts_with(place)) << "expected " << place << "…, got " << message;
  const auto split = message.find("; expected ");
  ASSERT_NE(split, std::string::npos) << message;
  EXPECT_NE(message.substr(0, split).find(mistake.found), std::string::npos) << message;
  EXPECT_NE(message.substr(split).find(mistake.expected), std::string::npos) << message;
}

}  // namespace grainproof
