// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "driver_process.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

/// oclgrind prints what it finds and still exits with the program's own code.
void expect_clean(const Finished& finished) {
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_NE(finished.output.find("digest"), std::string::npos) << finished.output;
  for (const char* complaint :
       {"race", "Invalid", "Uninitialized", "divergence", "Error", "ERROR", "warning"})
    EXPECT_EQ(finished.output.find(complaint), std::string::npos) << finished.output.substr(0, 4000);
}

// Out-of-bounds accesses and divergent barriers are looked for always. oclgrind 21.10 crashes by itself when
// it also looks for uninitialised values in code with vectors.
constexpr const char* checker = "oclgrind --data-races --max-errors 5";

/// A copy of the kernels whose small path has lost its barriers.
std::filesystem::path kernels_without_barriers() {
  const auto folder = std::filesystem::temp_directory_path() / "grainproof-kernels-without-barriers";
  std::filesystem::remove_all(folder);
  std::filesystem::copy(GRAINPROOF_KERNELS, folder);
  std::ifstream original(folder / "small.cl");
  std::string text{std::istreambuf_iterator<char>(original), {}};
  const std::string barrier = "barrier(CLK_GLOBAL_MEM_FENCE);";
  for (auto at = text.find(barrier); at != std::string::npos; at = text.find(barrier))
    text.erase(at, barrier.size());
  std::ofstream(folder / "small.cl") << text;
  return folder;
}

template <class Test>
class WithOclgrind : public Test {
 protected:
  void SetUp() override {
    if (std::system("command -v oclgrind >/dev/null 2>&1") != 0) FAIL() << "oclgrind is not installed";
  }
};

class Oclgrind : public WithOclgrind<::testing::TestWithParam<std::string>> {};
class OclgrindOnce : public WithOclgrind<::testing::Test> {};

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

TEST_F(OclgrindOnce, FindsTheRaceOfAMissingBarrier) {
  const auto folder = kernels_without_barriers();
  const std::string wrapped = "GRAINPROOF_TEST_KERNELS=" + folder.string() + " " + checker;
  const Finished finished = run_driver(wrapped, "double small boxed 2 12");
  EXPECT_NE(finished.output.find("race"), std::string::npos) << finished.output;
}

TEST_F(OclgrindOnce, FindsNothingWhereSpringsGoFromListToList) {
  expect_clean(run_driver(checker, "single zoned turning_liggghts 8 60"));
}

TEST_F(OclgrindOnce, FindsNothingInTheDensePath) {
  for (const char* scene : {"boxed", "damped_friction", "fixed", "tilted_plane", "turning_liggghts"})
    for (const char* precision : {"single", "double"})
      expect_clean(run_driver(checker, precision + std::string(" dense ") + scene + " 16 20"));
}

TEST_F(OclgrindOnce, FindsNothingInTheDensePathByOne) {
  for (const char* scene : {"boxed", "fixed", "turning_liggghts"})
    expect_clean(run_driver(checker, std::string("single dense_by_one ") + scene + " 16 20"));
}

TEST_F(OclgrindOnce, FindsNothingInABuildOfEveryStage) {
  for (const char* precision : {"single ", "double "})
    expect_clean(run_driver(checker, precision + std::string("zoned damped_friction 20 6 full")));
}

}  // namespace
}  // namespace grainproof::opencl::testing
