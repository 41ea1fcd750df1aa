// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>

#include "tests/app/program.hpp"

namespace grainproof::testing {
namespace {

constexpr const char* no_drivers = "OCL_ICD_VENDORS=/nonexistent OPENCL_VENDOR_PATH=/nonexistent";

/// settling.toml with another claim about the resting overlap.
std::string settling_with(const Scratch& scratch, const std::string& wanted, const std::string& changed) {
  std::string text = text_of("scenes/settling.toml");
  const std::size_t at = text.find(wanted);
  if (at == std::string::npos) throw std::runtime_error("settling.toml has no " + wanted);
  return scratch.file("changed.toml", text.replace(at, wanted.size(), changed));
}

TEST(VerifyCommand, ExitsWithZeroWhenAllHeld) {
  const Ended ended = run_program("verify settling --engines reference");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("resting_overlap"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("0 failed"), std::string::npos) << ended.out;
}

TEST(VerifyCommand, ExitsWithOneAndExplainsWhenAVerdictFailed) {
  const Scratch scratch;
  const std::string file = settling_with(scratch, "closed_form:settling", "value:2e-4");
  const Ended ended = run_program("verify --engines reference " + file);
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_NE(ended.out.find("FAIL"), std::string::npos);
  EXPECT_NE(ended.out.find("expected at most"), std::string::npos) << ended.out;
}

TEST(VerifyCommand, FailsACaseWhoseRunWentWrong) {
  const Scratch scratch;
  const std::string claim =
      "[[expect]]\nquantity = \"particles\"\nagainst = \"invariant:particles\"\nbelow = 0.0\n";
  const std::string file = scratch.file("escaping.toml", escaping_sphere() + claim);
  const Ended ended = run_program("verify --engines reference " + file);
  EXPECT_EQ(ended.code, 1) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("went wrong"), std::string::npos) << ended.out;
}

TEST(VerifyCommand, GoesOnWithoutOpenClDevice) {
  const Ended ended = run_program("verify settling --engines reference,opencl", no_drivers);
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_NE(ended.err.find("opencl:single is not available"), std::string::npos) << ended.err;
  EXPECT_NE(ended.out.find("3 passed, 0 failed"), std::string::npos) << ended.out;
}

TEST(VerifyCommand, GoesOnWithoutLammps) {
  const Ended ended = run_program("verify settling --engines reference,lammps", "PATH=/nonexistent");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.err.find("apt-get install lammps"), std::string::npos) << ended.err;
}

TEST(VerifyCommand, GoesOnWithoutLiggghts) {
  const Ended ended = run_program("verify settling --engines reference,liggghts", "PATH=/nonexistent");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_NE(ended.err.find("apt-get install liggghts"), std::string::npos) << ended.err;
}

TEST(VerifyCommand, RefusesWhenNoEngineIsThere) {
  const Ended ended = run_program("verify settling --engines opencl", no_drivers);
  EXPECT_EQ(ended.code, 2) << ended.out;
  EXPECT_NE(ended.err.find("doctor"), std::string::npos) << ended.err;
}

TEST(VerifyCommand, DoesNotExitWithZeroWhereNothingWasJudged) {
  const Scratch scratch;
  const std::string file = settling_with(scratch, "[run]", "[verify]\nno_peers = \"ours alone\"\n\n[run]");
  const std::string json = scratch.path("r.json").string();
  const Ended none = run_program("verify --engines lammps --json " + json + " " + file);
  EXPECT_EQ(none.code, 2) << none.out << none.err;
  EXPECT_NE(none.out.find("ours alone"), std::string::npos) << none.out;
  EXPECT_NE(none.err.find("nothing was judged"), std::string::npos) << none.err;
  EXPECT_NE(none.err.find("verify --list"), std::string::npos) << none.err;
  EXPECT_EQ(json_of(json)["results"].at(0)["verdict"], "unsupported");
  const Ended one = run_program("verify --engines lammps,reference " + file);
  EXPECT_EQ(one.code, 0) << one.out << one.err;
}

TEST(VerifyCommand, DoesNotExitWithZeroWhereNoClaimIsAboutAnEngineAskedFor) {
  const Scratch scratch;
  const std::string file = settling_with(scratch, "below = 1e-12", "below = 1e-12\nengines = [\"lammps\"]");
  const Ended ended = run_program("verify --engines reference " + file);
  EXPECT_EQ(ended.code, 2) << ended.out << ended.err;
  EXPECT_NE(ended.err.find("no claim that an engine asked for is held to"), std::string::npos) << ended.err;
}

TEST(VerifyCommand, WritesResultsAsTheSchemaSays) {
  const Scratch scratch;
  const std::string json = scratch.path("r.json").string();
  ASSERT_EQ(run_program("verify normal_collision_elastic --engines reference --json " + json).code, 0);
  const auto results = json_of(json);
  EXPECT_EQ(results["schema"], 1);
  EXPECT_TRUE(results["machine"].contains("processor"));
  ASSERT_FALSE(results["results"].empty());
  int orders = 0;
  for (const auto& row : results["results"]) {
    for (const char* key : {"case", "engine", "precision", "integrator", "quantity", "verdict", "reason"})
      EXPECT_TRUE(row[key].is_string()) << key << " in " << row;
    EXPECT_TRUE(row["wall_s"].is_number() && row["error"].is_number() && row.contains("tolerance")) << row;
    EXPECT_NE(row["step"].is_null(), row["order"].is_null()) << "a row has a step or an order: " << row;
    orders += row["order"].is_null() ? 0 : 1;
  }
  EXPECT_GT(orders, 0);
}

TEST(VerifyCommand, WritesAPageThatNeedsNothingElse) {
  const Scratch scratch;
  const std::string out = scratch.path("out").string();
  ASSERT_EQ(run_program("verify normal_collision_elastic --engines reference --out " + out).code, 0);
  const std::string page = text_of(out + "/report.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("normal_collision_elastic"), std::string::npos);
  for (const char* foreign : {"src=", "url(", "<script", "<link"})
    EXPECT_EQ(page.find(foreign), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(out + "/results.json"));
}

/// A folder of data with three cases, one of each tier.
std::string tiers_of(const Scratch& scratch) {
  for (const char* tier : {"quick", "standard", "bulk"}) {
    const std::filesystem::path file = scratch.path("scenes") / (std::string(tier) + "_case.toml");
    std::filesystem::create_directories(file.parent_path());
    std::string text = text_of("scenes/settling.toml");
    std::ofstream(file) << text.insert(text.find("[run]"), std::string("tier = \"") + tier + "\"\n");
  }
  std::filesystem::create_directories(scratch.path("kernels"));
  return "GRAINPROOF_DATA=" + scratch.path("").string();
}

TEST(VerifyCommand, ListsTheCasesThereAreAndRunsNone) {
  const Scratch scratch;
  const Ended ended = run_program("verify --list", tiers_of(scratch));
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const std::string tier : {"quick", "standard", "bulk"})
    EXPECT_NE(ended.out.find(tier + "_case"), std::string::npos) << ended.out;
  EXPECT_EQ(ended.out.find("passed"), std::string::npos) << ended.out;
}

TEST(VerifyCommand, RunsTheTiersAskedForAndNamesTheCasesItLeavesOut) {
  const Scratch scratch;
  const std::string data = tiers_of(scratch);
  const auto lines_about = [&](const std::string& flags) {
    return run_program("verify --engines reference " + flags, data);
  };
  const Ended quick = lines_about("--quick");
  EXPECT_EQ(quick.out.find("standard_case"), std::string::npos) << quick.out;
  EXPECT_NE(quick.err.find("left out: standard_case; without --quick"), std::string::npos) << quick.err;
  const Ended plain = lines_about("");
  EXPECT_NE(plain.out.find("standard_case"), std::string::npos) << plain.out << plain.err;
  EXPECT_NE(plain.err.find("left out: bulk_case; --bulk"), std::string::npos) << plain.err;
  const Ended all = lines_about("--bulk");
  EXPECT_NE(all.out.find("bulk_case"), std::string::npos) << all.out;
  EXPECT_EQ(all.err.find("left out"), std::string::npos) << all.err;
  EXPECT_NE(lines_about("bulk_case").out.find("bulk_case"), std::string::npos);
  EXPECT_EQ(lines_about("--quick --bulk").code, 2);
}

/// Times are all that may differ.
std::string timeless(std::string text) {
  return text.substr(0, text.rfind("; "));
}

TEST(VerifyCommand, SaysTheSameHoweverManyCasesItJudgesAtOnce) {
  const std::string cases =
      "verify mfix_03 settling free_fall drag wall_dragging --engines reference,opencl:single,opencl:double ";
  const Ended alone = run_program(cases + "--jobs 1"), together = run_program(cases + "--jobs 3");
  EXPECT_EQ(alone.code, 0) << alone.out << alone.err;
  EXPECT_EQ(together.code, alone.code);
  EXPECT_EQ(timeless(together.out), timeless(alone.out));
  EXPECT_EQ(together.err, alone.err);
}

TEST(VerifyCommand, JudgesAnExternalProgram) {
  const Scratch scratch;
  const std::string program =
      "python3 " + std::filesystem::absolute("comparisons/external/example/head_on_pair.py").string();
  const Ended ended = run_program("verify normal_collision_peers --engines \"external:" + program + "\"");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("external:"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("3 passed, 0 failed"), std::string::npos) << ended.out;
}

}  // namespace
}  // namespace grainproof::testing
