// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/app/program.hpp"

namespace grainproof::testing {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

double time_of(const std::string& csv_line) {
  return std::stod(csv_line.substr(0, csv_line.find(',')));
}

TEST(RunCommand, WritesSummaryAndFramesFromStartToEnd) {
  const Scratch scratch;
  const std::string scene = scratch.file("falling.toml", falling_sphere());
  const std::string out = scratch.path("out").string();
  const Ended ended =
      run_program("run " + scene + " --out " + out + " --csv --json " + scratch.path("s.json").string());
  ASSERT_EQ(ended.code, 0) << ended.err;

  const auto csv = lines_of(text_of(out + "/frames.csv"));
  ASSERT_EQ(csv.size(), 6U);
  EXPECT_EQ(csv.front(), "time,id,x,y,z,vx,vy,vz");
  EXPECT_EQ(time_of(csv[1]), 0.0);
  const auto summary = json_of(out + "/summary.json");
  EXPECT_EQ(summary, json_of(scratch.path("s.json")));
  EXPECT_DOUBLE_EQ(time_of(csv.back()), summary["steps"].get<double>() * summary["step"].get<double>());
  EXPECT_GE(time_of(csv.back()), 0.2);
  EXPECT_EQ(summary["frames"], 5);
  EXPECT_TRUE(std::filesystem::exists(out + "/frame_000004.vtp"));
  EXPECT_FALSE(std::filesystem::exists(out + "/frame_000005.vtp"));
}

TEST(RunCommand, SaysWhatChoseAStepThatIsGivenByItsError) {
  const Scratch scratch;
  const std::string scene =
      scratch.file("falling.toml", falling_sphere("step = \"contact/32\"", "step = { error = 1e-2 }"));
  const Ended ended = run_program("run " + scene + " --json " + scratch.path("s.json").string());
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("step chosen    error 0.01: "), std::string::npos) << ended.out;
  const auto because = json_of(scratch.path("s.json"))["step_because"].get<std::string>();
  EXPECT_NE(because.find("restitution 0.8"), std::string::npos) << because;
}

TEST(RunCommand, SummaryHasWhatItsReadersNeed) {
  const Scratch scratch;
  const std::string scene = scratch.file("falling.toml", falling_sphere());
  ASSERT_EQ(run_program("run " + scene + " --json " + scratch.path("s.json").string()).code, 0);
  const auto summary = json_of(scratch.path("s.json"));
  EXPECT_EQ(summary["schema"], 1);
  EXPECT_EQ(summary["outcome"]["status"], "completed");
  EXPECT_EQ(summary["provenance"]["engine"], "reference");
  EXPECT_GT(summary["cundall_number"].get<double>(), 0.0);
  EXPECT_GT(summary["peak_memory_bytes"].get<std::int64_t>(), 0);
  EXPECT_TRUE(summary["ledger"]["final"].contains("dissipated_normal"));
  for (const char* key : {"steps", "wall_s", "rebuilds", "contacts", "machine"})
    EXPECT_TRUE(summary.contains(key)) << key;
}

TEST(RunCommand, WritesWhatWallsGiveBetweenFrames) {
  const Scratch scratch;
  const std::string out = scratch.path("out").string();
  ASSERT_EQ(run_program("run settling --out " + out).code, 0);
  const auto lines = lines_of(text_of(out + "/walls.csv"));
  const auto summary = json_of(out + "/summary.json");
  ASSERT_EQ(lines.size(), summary["frames"].get<std::size_t>());  // a header, and no line for the first frame
  EXPECT_EQ(lines.front(), "time,wall,fx,fy,fz,tx,ty,tz");
  std::string last = lines.back();
  std::replace(last.begin(), last.end(), ',', ' ');
  std::istringstream words(last);
  std::string time, wall;
  double fx = 0.0, fy = 0.0, fz = 0.0;
  words >> time >> wall >> fx >> fy >> fz;
  const double weight = 2000.0 * std::numbers::pi * 1e-3 / 6.0 * 9.81;
  EXPECT_NEAR(std::hypot(fx, fy, fz) / weight, 1.0, 1e-6);  // at rest the floor carries it
}

TEST(RunCommand, KeepsNoLedgerWhereNoneIsWanted) {
  const Scratch scratch;
  const std::string out = scratch.path("out").string();
  ASSERT_EQ(run_program("run settling --no-ledger --out " + out).code, 0);
  EXPECT_FALSE(std::filesystem::exists(out + "/walls.csv"));
  EXPECT_TRUE(json_of(out + "/summary.json")["ledger"].is_null());
}

/// 8 × 8 × 8 of them in the air, for 20 steps.
std::string many_falling(const std::string& more = "") {
  return R"(schema = 1
title = "Many spheres in the air"
[run]
end = 2e-3
step = 1e-4
[domain]
lower = [0, 0, 0]
upper = [1, 1, 1]
boundary = ["periodic", "periodic", "wall"]
material = "glass"
[material.glass]
density = 2000.0
[[contact]]
between = ["glass", "glass"]
normal = { law = "linear", stiffness = 1e4, restitution = 0.8 }
[[particles]]
material = "glass"
diameter = 0.08
fill = { kind = "lattice", counts = [8, 8, 8], origin = [0.06, 0.06, 0.06], spacing = 0.12, jitter = 0.0, seed = 1 }
[field]
gravity = [0.0, 0.0, -9.81]
)" + more;
}

TEST(RunCommand, KeepsALedgerOfManyWhereItIsAskedForAlone) {
  const Scratch scratch;
  const std::string run = "run " + scratch.file("many.toml", many_falling()) + " --json ";
  const std::string file = scratch.path("s.json").string();
  const Ended plain = run_program(run + file);
  ASSERT_EQ(plain.code, 0) << plain.err;
  EXPECT_NE(plain.out.find("--ledger"), std::string::npos) << plain.out;
  const auto without = json_of(file);
  EXPECT_TRUE(without["ledger"].is_null());

  const Ended asked = run_program(run + file + " --ledger");
  ASSERT_EQ(asked.code, 0) << asked.err;
  const auto with = json_of(file);
  const auto& energies = without["energies"]["final"];
  const double kinetic = with["ledger"]["final"]["kinetic"], work = with["ledger"]["final"]["gravity_work"];
  EXPECT_GT(kinetic, 0.0);
  EXPECT_NEAR(energies["kinetic"].get<double>() / kinetic, 1.0, 1e-9);
  EXPECT_EQ(energies["elastic"], 0.0);
  const double fallen =
      without["energies"]["initial"]["gravitational"].get<double>() - energies["gravitational"].get<double>();
  EXPECT_NEAR(fallen / work, 1.0, 1e-6);
}

TEST(RunCommand, KeepsTheLedgerThatAClaimIsAbout) {
  const Scratch scratch;
  const std::string claim =
      "[[expect]]\nquantity = \"energy\"\nagainst = \"invariant:energy\"\nbelow = 1e-3\n";
  const std::string scene = scratch.file("many.toml", many_falling(claim));
  ASSERT_EQ(run_program("run " + scene + " --json " + scratch.path("s.json").string()).code, 0);
  EXPECT_FALSE(json_of(scratch.path("s.json"))["ledger"].is_null());
}

TEST(RunCommand, ThatGoesWrongSaysWhereKeepsTheLastGoodFrameAndExitsWithThree) {
  const Scratch scratch;
  const std::string scene = scratch.file("escaping.toml", escaping_sphere());
  const std::string out = scratch.path("out").string();
  const Ended ended = run_program("run " + scene + " --csv --out " + out);
  EXPECT_EQ(ended.code, 3) << ended.out;
  for (const std::string word : {"t = ", "step ", "particle", "domain"})
    EXPECT_NE(ended.err.find(word), std::string::npos) << word << " in " << ended.err;

  const auto summary = json_of(out + "/summary.json");
  EXPECT_EQ(summary["outcome"]["status"], "went_wrong");
  const auto csv = lines_of(text_of(out + "/frames.csv"));
  const double went_wrong_at = summary["outcome"]["time"].get<double>();
  EXPECT_NEAR(time_of(csv.back()), went_wrong_at, 1.5 * summary["step"].get<double>());
  EXPECT_LT(time_of(csv.back()), went_wrong_at);
}

TEST(RunCommand, TakesTheSceneOfASweepThatIsAskedFor) {
  const Scratch scratch;
  const std::string text = falling_sphere() + "[sweep]\nstep = [\"contact/16\", \"contact/32\"]\n";
  const std::string scene =
      scratch.file("swept.toml", text.substr(0, text.find("step = ")) + text.substr(text.find("record")));
  const Ended first = run_program("run " + scene + " --json " + scratch.path("first.json").string());
  const Ended second =
      run_program("run " + scene + " --nth 2 --json " + scratch.path("second.json").string());
  ASSERT_EQ(first.code, 0) << first.err;
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_NE(first.err.find("expands to 2 scenes"), std::string::npos) << first.err;
  const double ratio = json_of(scratch.path("first.json"))["step"].get<double>() /
                       json_of(scratch.path("second.json"))["step"].get<double>();
  EXPECT_DOUBLE_EQ(ratio, 2.0);
}

TEST(RunCommand, IsSilentOnStandardErrorWhenQuiet) {
  EXPECT_EQ(run_program("--quiet run settling").err, "");
  EXPECT_EQ(run_program("run settling --quiet").err, "");
}

TEST(CompareCommand, FindsAnEngineEqualToItselfAndTheClosedFormApart) {
  const Scratch scratch;
  const std::string json = scratch.path("apart.json").string();
  const Ended ended =
      run_program("compare normal_collision --engines reference,reference,analytic --json " + json);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto apart = json_of(json);
  ASSERT_EQ(apart["differences"].size(), 2U);
  for (const auto& frame : apart["differences"][0]["frames"]) EXPECT_EQ(frame["position"], 0.0);
  EXPECT_GT(apart["differences"][1]["frames"].back()["velocity"].get<double>(), 1e-4);
  EXPECT_EQ(apart["engines"][0]["engine"], "reference");
}

TEST(CompareCommand, WritesTheFramesOfEveryEngine) {
  const Scratch scratch;
  const std::string scene = scratch.file("falling.toml", falling_sphere());
  ASSERT_EQ(run_program("compare " + scene + " --engines reference,opencl:double --out " +
                        scratch.path("out").string())
                .code,
            0);
  EXPECT_EQ(lines_of(text_of(scratch.path("out/reference/frames.csv"))).size(), 6U);
  EXPECT_EQ(lines_of(text_of(scratch.path("out/opencl-double/frames.csv"))).size(), 6U);
  EXPECT_TRUE(std::filesystem::exists(scratch.path("out/compare.json")));
}

}  // namespace
}  // namespace grainproof::testing
