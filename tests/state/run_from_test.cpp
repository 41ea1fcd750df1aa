// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>

#include "tests/app/program.hpp"

namespace grainproof::testing {
namespace {
namespace fs = std::filesystem;

std::string digest_in(const fs::path& folder) {
  return json_of(folder / "summary.json")["digest"];
}

std::string changed(std::string text, const std::string& wanted, const std::string& put) {
  return text.replace(text.find(wanted), wanted.size(), put);
}

std::string run_into(const Scratch& scratch, const std::string& scene, const std::string& name,
                     const std::string& more = "") {
  const Ended ended =
      run_program("--quiet run " + scene + " --out " + scratch.path(name).string() + " " + more);
  EXPECT_EQ(ended.code, 0) << ended.err;
  return digest_in(scratch.path(name));
}

TEST(RunFrom, ACheckpointGivesTheDigestOfTheWholeRun) {
  const Scratch scratch;
  const std::string scene = scratch.file("ball.toml", falling_sphere());
  const std::string whole = run_into(scratch, scene, "whole");
  EXPECT_EQ(whole.size(), 16u);
  EXPECT_EQ(run_into(scratch, scene, "written", "--checkpoint-every 70"), whole);
  const auto checkpoint = scratch.path("written/checkpoint.h5");
  ASSERT_TRUE(fs::exists(checkpoint));
  EXPECT_EQ(run_into(scratch, scene, "from", "--from " + checkpoint.string()), whole);
  const auto summary = json_of(scratch.path("from/summary.json"));
  EXPECT_GT(summary["first_step"], 0);
  EXPECT_EQ(summary["steps"], json_of(scratch.path("whole/summary.json"))["steps"]);
  EXPECT_EQ(summary["ledger"]["final"], json_of(scratch.path("whole/summary.json"))["ledger"]["final"]);
  EXPECT_EQ(run_into(scratch, scene, "bare", "--no-sentinels --no-ledger --csv"), whole);
}

// What is longer, recorded more often or called otherwise is the same run.
TEST(RunFrom, ARunGoesOnLongerThanItWasAskedTo) {
  const Scratch scratch;
  const std::string scene = scratch.file("ball.toml", falling_sphere());
  const std::string longer = scratch.file("longer.toml", falling_sphere("end = 0.2", "end = 0.4"));
  run_into(scratch, scene, "short", "--checkpoint-every 70");
  const std::string from = "--from " + scratch.path("short/checkpoint.h5").string();
  EXPECT_EQ(run_into(scratch, longer, "on", from), run_into(scratch, longer, "whole"));
}

TEST(RunFrom, WhatCannotBeGoneOnFromIsRefused) {
  const Scratch scratch;
  const std::string scene = scratch.file("ball.toml", falling_sphere());
  run_into(scratch, scene, "out", "--checkpoint-every 70");
  const std::string from = " --from " + scratch.path("out/checkpoint.h5").string();
  const std::string stiffer = scratch.file("ball2.toml", falling_sphere("1e5", "2e5"));
  const Ended other = run_program("run " + stiffer + from);
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("not of ball2; what differs: contacts, run"), std::string::npos) << other.err;
  const Ended shorter =
      run_program("run " + scratch.file("ball.toml", falling_sphere("end = 0.2", "end = 0.001")) + from);
  EXPECT_EQ(shorter.code, 2);
  EXPECT_NE(shorter.err.find("ends at"), std::string::npos) << shorter.err;
  EXPECT_EQ(run_program("run " + scene + " --from " + scene).code, 2);
  EXPECT_EQ(run_program("run " + scene + " --checkpoint-every 10").code, 2);
  EXPECT_EQ(
      run_program("run " + scene + " --checkpoint-every often --out " + scratch.path("x").string()).code, 2);
}

TEST(Digest, IsTheSameForShuffledLinesOfParticles) {
  const Scratch scratch;
  const auto with = [&](const std::string& name, const std::string& lines) {
    return scratch.file(name, falling_sphere("positions = [[0.0, 0.0, 0.1]]", lines) +
                                  "\n[[particles]]\nmaterial = \"glass\"\ndiameter = 0.1\nids = [7]\n"
                                  "positions = [[0.03, 0.0, 0.35]]\n");
  };
  const std::string one = with("one.toml", "ids = [3, 5]\npositions = [[0.0, 0.0, 0.1], [0.05, 0.05, 0.19]]");
  const std::string other =
      with("other.toml", "ids = [5, 3]\npositions = [[0.05, 0.05, 0.19], [0.0, 0.0, 0.1]]");
  EXPECT_EQ(run_into(scratch, one, "a"), run_into(scratch, other, "b"));
}

/// A cache of compiled kernels and of passed tests of its own.
std::string own_caches(const Scratch& scratch) {
  return "XDG_CACHE_HOME='" + scratch.path("cache").string() + "' POCL_CACHE_DIR='" GRAINPROOF_POCL_CACHE "'";
}

/// As many as take the dense path.
std::string many_falling_spheres() {
  std::string places;
  for (int k = 0; k < 512; ++k)
    places += (k ? ", [" : "[") + std::to_string(-0.9 + 0.12 * (k % 16)) + ", " +
              std::to_string(-0.7 + 0.2 * (k / 16 % 8)) + ", " + std::to_string(0.1 + 0.2 * (k / 128)) + "]";
  return falling_sphere("[[0.0, 0.0, 0.1]]", "[" + places + "]");
}

TEST(SelfTest, IsDoneOnceForAnIntegratorAndRemembered) {
  const Scratch scratch;
  const std::string run = "run " + scratch.file("ball.toml", falling_sphere()) + " --engine opencl:double";
  const Ended once = run_program(run, own_caches(scratch));
  EXPECT_EQ(once.code, 0) << once.err;
  EXPECT_NE(once.err.find("testing the kernels"), std::string::npos) << once.err;
  const Ended again = run_program(run, own_caches(scratch));
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(again.err.find("testing the kernels"), std::string::npos) << again.err;
  const std::string plain = falling_sphere("end = 0.2", "end = 0.2\nintegrator = \"velocity_verlet\"");
  const Ended other = run_program("run " + scratch.file("plain.toml", plain) + " --engine opencl:double",
                                  own_caches(scratch));
  EXPECT_EQ(other.code, 0) << other.err;
  EXPECT_NE(other.err.find("testing the kernels"), std::string::npos) << other.err;
}

/// One piece of one kernel, broken; and what the self-test must say of it.
struct Broken {
  std::string file, printed, planted, told;
  bool many = false;  ///< in a run of so many spheres that the dense path takes them
};

void expect_found(const Broken& broken) {
  const Scratch scratch;
  const fs::path data = scratch.path("data");
  fs::create_directories(data);
  for (const char* folder : {"kernels", "scenes"})
    fs::copy(fs::current_path() / folder, data / folder, fs::copy_options::recursive);
  std::string law = text_of(data / "kernels" / broken.file);
  ASSERT_NE(law.find(broken.printed), std::string::npos);
  law.replace(law.find(broken.printed), broken.printed.size(), broken.planted);
  std::ofstream(data / "kernels" / broken.file) << law;
  const std::string scene = broken.many ? many_falling_spheres() : falling_sphere();
  const std::string run = "run " + scratch.file("ball.toml", scene) + " --engine opencl:double";
  const std::string wrapped = "GRAINPROOF_DATA='" + data.string() + "' " + own_caches(scratch);
  const Ended refused = run_program(run, wrapped);
  EXPECT_EQ(refused.code, 3) << refused.out;
  EXPECT_NE(refused.err.find(broken.told), std::string::npos) << refused.err;
  EXPECT_EQ(run_program(run + " --no-self-test", wrapped).code, 0);
}

TEST(SelfTest, FindsABrokenKernel) {
  expect_found({"linear_normal.cl", "law.damping_root_mass", "(real)0.9 * law.damping_root_mass",
                "normal_collision on the small path with onset_corrected is off"});
}

TEST(SelfTest, FindsABrokenKernelOfTheDensePath) {
  expect_found({"dense_contact.cl", "-(damping * separating)", "-((real)0.9f * damping * separating)",
                "onset_history on the dense path with onset_corrected is off", true});
}

// A tenth of what a contact that begins or ends does beside the plain scheme: too little for a closed form.
TEST(SelfTest, FindsABrokenKernelOfTheIntegratorThatRuns) {
  expect_found({"onset_flow.cl", "gain += n * next;", "gain += (real)0.9 * n * next;",
                "onset_history on the small path with onset_corrected is off"});
  expect_found({"dense_flow.cl", "gain = fma(next, (reals)((real)n), gain);",
                "gain = fma(next, (reals)((real)(0.9 * n)), gain);",
                "onset_history on the dense path with onset_corrected is off", true});
}

// GRAINPROOF_KILLS=50 for the long form.
TEST(RunFrom, AKillLeavesTheLastWholeCheckpoint) {
  const Scratch scratch;
  const std::string scene = scratch.file("ball.toml", falling_sphere("end = 0.2", "end = 200.0"));
  const fs::path out = scratch.path("out"), checkpoint = out / "checkpoint.h5";
  const char* asked = std::getenv("GRAINPROOF_KILLS");
  const int kills = asked != nullptr ? std::atoi(asked) : 4;
  std::int64_t reached = 0;
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 dice(seed);
  for (int k = 0; k < kills; ++k) {
    const std::string from = fs::exists(checkpoint) ? " --from " + checkpoint.string() : "";
    const std::string seconds = std::to_string(0.3 + 1e-3 * static_cast<double>(dice() % 1000));
    const std::string command = "GRAINPROOF_DATA='" + fs::current_path().string() + "' timeout -s KILL " +
                                seconds + " '" GRAINPROOF_PROGRAM "' --quiet run " + scene + from +
                                " --checkpoint-every 200 --out " + out.string() + " >/dev/null 2>" +
                                scratch.path("err").string();
    ASSERT_NE(std::system(command.c_str()), 0) << "the run ended before it was killed";
    ASSERT_EQ(text_of(scratch.path("err")).find("grainproof:"), std::string::npos)
        << text_of(scratch.path("err"));
    if (!fs::exists(checkpoint)) continue;
    // A scene that ends before the checkpoint refuses it only once it has been read as a whole.
    const Ended taken =
        run_program("--quiet run " + scratch.file("ball.toml", falling_sphere("end = 0.2", "end = 1e-9")) +
                    " --from " + checkpoint.string());
    EXPECT_NE(taken.err.find("and the scene ends at"), std::string::npos) << taken.err;
    scratch.file("ball.toml", falling_sphere("end = 0.2", "end = 200.0"));
    ++reached;
  }
  EXPECT_GT(reached, kills / 2);
}

TEST(Sentinels, TellOfEnergyFromNowhereAndKeepTheLastGoodState) {
  const Scratch scratch;
  // An elastic spring is beyond its stable step at contact/1.57; the sphere starts on it.
  std::string text = changed(falling_sphere(), "restitution = 0.8", "restitution = 1.0");
  text = changed(text, "step = \"contact/32\"", "step = \"contact/1.4\"\noverlap_limit = 1.99");
  text = changed(text, "every = 0.05", "every = 0.005");
  const std::string scene = scratch.file("ball.toml", changed(text, "0.0, 0.0, 0.1]", "0.0, 0.0, 0.0499]"));
  const Ended ended = run_program("run " + scene + " --force --out " + scratch.path("out").string());
  EXPECT_EQ(ended.code, 3) << ended.out;
  EXPECT_NE(ended.err.find("came from no source"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("the likely cause is a step too large"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("last_good.h5"), std::string::npos) << ended.err;
  EXPECT_TRUE(fs::exists(scratch.path("out/last_good.h5")));
}

TEST(Sentinels, OfTheEnginesKeepTheStateBeforeToo) {
  const Scratch scratch;
  const std::string scene = scratch.file("lost.toml", escaping_sphere());
  const Ended ended = run_program("run " + scene + " --out " + scratch.path("out").string());
  EXPECT_EQ(ended.code, 3);
  EXPECT_NE(ended.err.find("is kept in"), std::string::npos) << ended.err;
  const Ended again = run_program("run " + scene + " --from " + scratch.path("out/last_good.h5").string());
  EXPECT_EQ(again.code, 3) << again.err;
}

TEST(CompareExact, FindsTheFirstStepAndParticle) {
  const Scratch scratch;
  const std::string ball = falling_sphere("step = \"contact/32\"", "step = 1e-4");
  const std::string scene = scratch.file("ball.toml", ball);
  const std::string other =
      scratch.file("other.toml", changed(ball, "restitution = 0.8", "restitution = 0.81"));
  const Ended same = run_program("--quiet compare " + scene + " --exact reference,reference");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_NE(same.out.find("the same bits"), std::string::npos) << same.out;
  const Ended apart = run_program("--quiet compare " + scene + " --exact reference --other " + other +
                                  " --json " + scratch.path("exact.json").string());
  EXPECT_EQ(apart.code, 1) << apart.err;
  const auto json = json_of(scratch.path("exact.json"));
  EXPECT_FALSE(json["same"]);
  EXPECT_EQ(json["differs"]["particle"], 1);
  // The time that the contact has lasted by the first boundary moves the sphere, too.
  EXPECT_EQ(json["differs"]["what"], "position z");
  // A sphere that falls by 5 cm touches after 0.101 s, and no bit differs before.
  EXPECT_NEAR(json["differs"]["time"], 0.101, 0.001);
  EXPECT_EQ(run_program("compare " + scene + " --exact reference").code, 2);
  EXPECT_EQ(run_program("compare " + scene + " --exact analytic,reference").code, 2);
}

}  // namespace
}  // namespace grainproof::testing
