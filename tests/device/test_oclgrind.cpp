// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "driver_process.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

/// oclgrind prints what it finds and still exits with the program's own code.
void expect_clean(const Finished& finished) {
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_NE(finished.output.find("digest"), std::string::npos) << finished.output;
  for (const char* complaint : {"race", "Invalid", "Uninitialized", "divergence", "Error", "warning"})
    EXPECT_EQ(finished.output.find(complaint), std::string::npos) << finished.output.substr(0, 4000);
}

constexpr const char* checker = "oclgrind --data-races --uninitialized --max-errors 5";

class Oclgrind : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (std::system("command -v oclgrind >/dev/null 2>&1") != 0) GTEST_SKIP() << "oclgrind is not installed";
  }
};

TEST_P(Oclgrind, FindsNothingInTheZonedPath) {
  for (const char* precision : {"single ", "double "})
    expect_clean(run_driver(checker, precision + std::string("zoned ") + GetParam() + " 12 12"));
}

TEST_P(Oclgrind, FindsNothingInTheSmallPath) {
  for (const char* precision : {"single ", "double "})
    expect_clean(run_driver(checker, precision + std::string("small ") + GetParam() + " 2 12"));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Oclgrind, ::testing::ValuesIn(varied_scene_names()),
                         [](const ::testing::TestParamInfo<std::string>& param) { return param.param; });

TEST_F(Oclgrind, FindsNothingInABuildOfEveryStage) {
  for (const char* precision : {"single ", "double "})
    expect_clean(run_driver(checker, precision + std::string("zoned damped_friction 20 6 full")));
}

}  // namespace
}  // namespace grainproof::opencl::testing
