// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "driver_process.hpp"
#include "opencl/build_options.hpp"
#include "opencl/dense_options.hpp"
#include "rare_scenes.hpp"
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
    text.replace(at, barrier.size(), ";");
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
  expect_clean(run_driver(checker, "single zoned " + GetParam() + " 12 12 pressed"));
}

TEST_P(Oclgrind, FindsNothingInTheSmallPath) {
  expect_clean(run_driver(checker, "double small " + GetParam() + " 4 12 pressed"));
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
      expect_clean(run_driver(checker, precision + std::string(" dense ") + scene + " 16 20 pressed"));
}

TEST_F(OclgrindOnce, FindsNothingInTheDensePathByOne) {
  for (const char* scene : {"boxed", "fixed", "turning_liggghts"})
    expect_clean(run_driver(checker, std::string("single dense_by_one ") + scene + " 16 20 pressed"));
}

TEST_F(OclgrindOnce, FindsNothingInTheDensePathOfContactsThatBeginOrEnd) {
  for (const char* how : {"single dense onset", "double dense onset_turning",
                          "single dense predicted_turning", "single dense_by_one predicted_turning"})
    expect_clean(run_driver(checker, std::string(how) + " 16 20 pressed"));
}

TEST_F(OclgrindOnce, FindsNothingInTheDensePathInCanonicalOrder) {
  for (const char* precision : {"single", "double"})
    expect_clean(run_driver(checker, precision + std::string(" dense turning_liggghts 16 12 canonical pressed")));
}

TEST_F(OclgrindOnce, FindsNothingWhereALedgerIsKept) {
  for (const char* scene : {"leapfrog_verlet", "turning_liggghts", "drum", "onset_turning"})
    expect_clean(run_driver(checker, std::string("double zoned ") + scene + " 8 8 ledger pressed"));
}

TEST_F(OclgrindOnce, FindsNothingInScenesOfTheSmallPathAlone) {
  for (const std::string& scene : rare_scene_names(true))
    expect_clean(run_driver(checker, "double small " + scene + " 3 12 pressed"));
}

class OclgrindRarely : public WithOclgrind<::testing::TestWithParam<std::string>> {};

TEST_P(OclgrindRarely, FindsNothingOnEitherPath) {
  for (const char* how : {"single zoned ", "double small "})
    expect_clean(run_driver(checker, how + GetParam() + " 4 12 pressed"));
}

INSTANTIATE_TEST_SUITE_P(Scenes, OclgrindRarely, ::testing::ValuesIn(rare_scene_names()),
                         [](const ::testing::TestParamInfo<std::string>& param) { return param.param; });

/// What the programs of the runs above are made of.
std::set<std::string> files_run_above() {
  std::set<std::string> files;
  const auto add = [&](const std::vector<std::string>& some) { files.insert(some.begin(), some.end()); };
  std::vector<std::string> names = varied_scene_names();
  for (const std::string& name : rare_scene_names()) names.push_back(name);
  for (const std::string& name : names)
    for (const bool small : {false, true})
      add(kernel_files(build_options(any_scene(name, 2), {}, Precision::single_precision, small), false));
  for (const std::string& name : rare_scene_names(true))
    add(kernel_files(build_options(any_scene(name, 2), {}, Precision::double_precision, true), false));
  Request ledger;
  ledger.ledger = true;
  add(kernel_files(build_options(any_scene("onset_turning", 8), ledger, Precision::double_precision, false),
                   false));
  const BuildOptions some =
      build_options(varied_scene("damped_friction"), {}, Precision::double_precision, false);
  add(kernel_files(with_every_stage(some), false));
  for (const SumOrder order : {SumOrder::fast, SumOrder::canonical}) {
    Scene scene = varied_scene("turning_liggghts");
    scene.run.order = order;
    DenseOptions options = dense_options(scene, Precision::double_precision);
    for (const bool one : {false, true}) {
      options.one = one;
      add(dense_kernel_files(options, false));
    }
    scene.run.integrator = Integrator::onset_corrected;
    add(dense_kernel_files(dense_options(scene, Precision::double_precision), false));
  }
  return files;
}

/// The kinds of numbers: each is in every program of a precision, a device or a width.
bool is_of_numbers(const std::string& file) {
  return std::ranges::any_of(std::array{"math_", "real_", "position_", "lengths_", "velocity_", "wide_"},
                             [&](const char* kind) { return file.starts_with(kind); });
}

TEST(OclgrindRuns, HaveEveryKernelFileAmongThem) {
  const auto run = files_run_above();
  for (const auto& entry : std::filesystem::directory_iterator(GRAINPROOF_KERNELS)) {
    const std::string file = entry.path().filename();
    EXPECT_TRUE(run.contains(file) || is_of_numbers(file)) << file << " is run by no test with oclgrind";
  }
}

TEST_F(OclgrindOnce, FindsNothingInABuildOfEveryStage) {
  for (const char* precision : {"single ", "mixed ", "double "})
    expect_clean(run_driver(checker, precision + std::string("zoned damped_friction 20 6 full pressed")));
}

}  // namespace
}  // namespace grainproof::opencl::testing
