// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

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
  for (const char* complaint : {"race", "Invalid", "ninitialized", "divergence", "Error", "ERROR", "warning"})
    EXPECT_EQ(finished.output.find(complaint), std::string::npos) << finished.output.substr(0, 4000);
}

// Out-of-bounds accesses and divergent barriers are looked for always.
constexpr const char* checker = "oclgrind --data-races --max-errors 5";

// Values that nobody wrote are looked for in code that is neither optimised nor inlined: of the optimised,
// oclgrind 21.10 does not know the instruction `freeze`; of the inlined, not
// `llvm.experimental.noalias.scope.decl`.
constexpr const char* definedness =
    "oclgrind --uninitialized --max-errors 5 --build-options '-O0 -Dalways_inline=noinline'";

/// A copy of the kernels, one file of which has all of one text replaced by another.
std::filesystem::path spoilt_kernels(const std::string& file, const std::string& from,
                                     const std::string& to) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("grainproof-spoilt-kernels-" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::copy(GRAINPROOF_KERNELS, folder);
  std::ifstream original(folder / file);
  std::string text{std::istreambuf_iterator<char>(original), {}};
  EXPECT_NE(text.find(from), std::string::npos) << file << " has no " << from;
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  std::ofstream(folder / file) << text;
  return folder;
}

/// What oclgrind, called so, says of a run with kernels that are spoilt like that.
std::string said_of(const char* how, const std::string& run, const std::string& file, const std::string& from,
                    const std::string& to) {
  const auto kernels = spoilt_kernels(file, from, to);
  const Finished finished = run_driver("GRAINPROOF_TEST_KERNELS=" + kernels.string() + " " + how, run);
  std::filesystem::remove_all(kernels);
  return finished.output;
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
  const std::string said =
      said_of(checker, "double small boxed 2 12", "small.cl", "barrier(CLK_GLOBAL_MEM_FENCE);", ";");
  EXPECT_NE(said.find("race"), std::string::npos) << said;
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
  for (const char* how : {"single dense onset", "double dense onset_turning", "single dense onset_bending",
                          "double dense onset_bending", "single dense predicted_turning",
                          "single dense_by_one predicted_turning"})
    expect_clean(run_driver(checker, std::string(how) + " 16 20 pressed"));
}

TEST_F(OclgrindOnce, FindsNothingInTheDensePathInCanonicalOrder) {
  for (const char* precision : {"single", "double"})
    expect_clean(
        run_driver(checker, precision + std::string(" dense turning_liggghts 16 12 canonical pressed")));
}

TEST_F(OclgrindOnce, FindsNothingWhereALedgerIsKept) {
  for (const char* scene : {"leapfrog_verlet", "turning_liggghts", "drum", "onset_turning", "onset_bending"})
    expect_clean(run_driver(checker, std::string("double zoned ") + scene + " 8 8 ledger pressed"));
}

TEST_F(OclgrindOnce, FindsNothingInScenesOfTheSmallPathAlone) {
  for (const std::string& scene : rare_scene_names(true))
    expect_clean(run_driver(checker, "double small " + scene + " 3 12 pressed"));
}

/// A run of two steps that is asked for values that nobody wrote: together they have every kernel file but
/// those that take many bodies at a time, where oclgrind takes the upper half of a vector that is halved for
/// undefined.
struct DefinedRun {
  const char* precision;
  const char* path;
  const char* scene;
  int layers;
  bool ledger = false;
  bool canonical = false;

  std::string text() const {
    return std::string(precision) + " " + path + " " + scene + " " + std::to_string(layers) +
           " 2 pressed hoarding" + (ledger ? " ledger" : "") + (canonical ? " canonical" : "");
  }
  std::vector<std::string> files() const;
};

constexpr DefinedRun defined_runs[] = {{"mixed", "small", "onset_turning", 2},
                                       {"double", "small", "onset_bending", 2, true},
                                       {"double", "small", "paddle", 4, true},
                                       {"single", "small", "implicit_in_vortices", 2, true},
                                       {"single", "small", "rolling_steadily", 2, true},
                                       {"single", "small", "euler_trapezoid", 2, true},
                                       {"single", "small", "drum", 2, true},
                                       {"single", "small", "composed", 2},
                                       {"single", "small", "turning_in_rectangles", 2, true},
                                       {"single", "small", "rotating_gravity", 2, true},
                                       {"double", "small", "onset_hertz", 2, true},
                                       {"single", "small", "implicit_drag", 2, true},
                                       {"single", "zoned", "onset", 3, true},
                                       {"single", "zoned", "implicit_turning", 3, true},
                                       {"single", "zoned", "turning_liggghts", 3},
                                       {"single", "dense_by_one", "boxed", 4},
                                       {"single", "dense_by_one", "predicted_turning", 4},
                                       {"double", "dense_by_one", "turning_liggghts", 4},
                                       {"single", "dense_by_one", "turning_liggghts", 4, false, true}};

std::string named_as_asked(const ::testing::TestParamInfo<DefinedRun>& run) {
  std::string name = run.param.text();
  std::ranges::replace(name, ' ', '_');
  return name;
}

class OclgrindDefined : public WithOclgrind<::testing::TestWithParam<DefinedRun>> {};

TEST_P(OclgrindDefined, FindsNoValueThatNobodyWrote) {
  expect_clean(run_driver(definedness, GetParam().text()));
}

INSTANTIATE_TEST_SUITE_P(Runs, OclgrindDefined, ::testing::ValuesIn(defined_runs), named_as_asked);

TEST_F(OclgrindOnce, FindsAValueThatNobodyWroteInAContact) {
  const char* pair = "c.root_mass = effective_root_mass(self.inverse_mass, other.inverse_mass);";
  const std::string said =
      said_of(definedness, "double small boxed 2 2 pressed hoarding", "spheres.cl", pair, "");
  EXPECT_NE(said.find("Uninitialized value written"), std::string::npos) << said;
}

TEST_F(OclgrindOnce, FindsAValueThatNobodyWroteInAContactOfTheDensePath) {
  const char* wall = "m.root_mass = roots_of(1 / (met ? b.inverse_mass : (reals)(1)));";
  const std::string said =
      said_of(definedness, "single dense_by_one boxed 4 2 pressed hoarding", "dense_walls.cl", wall, "");
  EXPECT_NE(said.find("ninitialized"), std::string::npos) << said;
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

std::vector<std::string> DefinedRun::files() const {
  const Precision number = precision_named(precision).value();
  Scene subject = any_scene(scene, layers);
  if (canonical) subject.run.order = SumOrder::canonical;
  Request request;
  request.ledger = ledger;
  if (std::string(path) == "dense_by_one")
    return dense_kernel_files(dense_options(subject, number, true), false);
  return kernel_files(build_options(subject, request, number, std::string(path) == "small"), false);
}

TEST(OclgrindRuns, LookForValuesThatNobodyWroteInEveryKernelFileWithoutVectors) {
  std::set<std::string> run{"math_pocl.cl"};  // of another device
  for (const DefinedRun& one : defined_runs)
    for (const std::string& file : one.files()) run.insert(file);
  for (const char* of_many :
       {"dense_before.cl", "dense_bend.cl", "dense_flow.cl", "dense_list.cl", "dense_onset.cl",
        "dense_seek.cl", "dense_shares.cl", "dense_slide.cl", "wide_double_8.cl", "wide_single_16.cl"})
    run.insert(of_many);
  for (const auto& entry : std::filesystem::directory_iterator(GRAINPROOF_KERNELS))
    EXPECT_TRUE(run.contains(entry.path().filename())) << entry.path().filename();
}

TEST_F(OclgrindOnce, FindsNothingInABuildOfEveryStage) {
  for (const char* precision : {"single ", "mixed ", "double "})
    expect_clean(run_driver(checker, precision + std::string("zoned damped_friction 20 6 full pressed")));
}

}  // namespace
}  // namespace grainproof::opencl::testing
