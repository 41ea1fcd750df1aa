// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/app/program.hpp"

namespace grainproof::testing {
namespace {

/// What is refused, and words that its message must have.
struct Refused {
  const char* name;
  const char* arguments;
  std::vector<std::string> words;
};

void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.arguments;
}

class Refusal : public ::testing::TestWithParam<Refused> {};

TEST_P(Refusal, ExitsWithTwoAndSaysWhatThereIs) {
  const Ended ended = run_program(GetParam().arguments);
  EXPECT_EQ(ended.code, 2) << ended.out << ended.err;
  EXPECT_EQ(ended.out, "");
  for (const std::string& word : GetParam().words)
    EXPECT_NE(ended.err.find(word), std::string::npos) << ended.err;
}

INSTANTIATE_TEST_SUITE_P(
    Program, Refusal,
    ::testing::Values(
        Refused{"NoCommand", "", {"Usage", "verify"}},
        Refused{"UnknownCommand", "prove", {"no command prove", "verify", "run"}},
        Refused{"UnknownOption", "verify --colour", {"--colour"}}, Refused{"MissingScene", "run", {"scene"}},
        Refused{"UnknownCase", "verify no_such_case", {"no_such_case", "verify --list"}},
        Refused{"UnknownScene", "run setling", {"setling", "expected settling"}},
        Refused{"MissingSceneFile", "run nowhere/scene.toml", {"no file nowhere/scene.toml"}},
        Refused{"UnknownEngine",
                "verify settling --engines mirror",
                {"mirror", "reference", "opencl", "liggghts"}},
        Refused{"UnknownEngineOfRun", "run settling --engine mirror", {"mirror", "reference"}},
        Refused{"UnknownPrecision", "run settling --engine opencl:half", {"half", "single", "double"}},
        Refused{"PrecisionOfReference", "run settling --precision single", {"single", "opencl"}},
        Refused{"UnknownClosedForm", "run settling --engine analytic:none", {"none", "settling"}},
        Refused{"ReferenceWithRest", "run settling --engine reference:double", {"reference alone"}},
        Refused{"ExternalWithoutCommand", "run settling --engine external", {"external:COMMAND"}},
        Refused{"UnknownDevice", "run settling --engine opencl --device nonesuch", {"nonesuch"}},
        Refused{"UnknownDeviceOfVerify", "verify settling --device nonesuch", {"nonesuch"}},
        Refused{"SceneBeyondTheSweep", "run settling --nth 1000000", {"1000000", "scenes"}},
        Refused{
            "ComparedWithNothing", "compare settling --engines reference", {"two engines", "only reference"}},
        Refused{"CsvWithoutFolder", "run settling --csv", {"--csv requires --out"}},
        Refused{"BenchOfAnUnknownSuite", "bench sclaing", {"no suite sclaing", "scaling:"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Refusal, OfASceneNamesFileAndLine) {
  const Scratch scratch;
  const std::string file = scratch.file("typo.toml", falling_sphere("density", "densty"));
  for (const std::string command : {"run ", "verify "}) {
    const Ended ended = run_program(command + file);
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find(file + ":"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("densty"), std::string::npos) << ended.err;
  }
}

TEST(Refusal, OfAClaimAboutWhatDoesNotExistNamesItsLine) {
  const Scratch scratch;
  const std::string claim = "[[expect]]\nquantity = \"velocty\"\nagainst = \"engine:reference\"\nbelow = 1\n";
  const std::string file = scratch.file("claim.toml", falling_sphere("schema", "schema") + claim);
  const Ended quantity = run_program("verify " + file);
  EXPECT_EQ(quantity.code, 2) << quantity.out;
  EXPECT_NE(quantity.err.find(":26:"), std::string::npos) << quantity.err;
  EXPECT_NE(quantity.err.find("expected \"velocity\""), std::string::npos) << quantity.err;
}

TEST(Refusal, OfACaseThatClaimsNothing) {
  const Scratch scratch;
  const std::string file = scratch.file("silent.toml", falling_sphere("schema", "schema"));
  const Ended ended = run_program("verify " + file);
  EXPECT_EQ(ended.code, 2) << ended.out;
  EXPECT_NE(ended.err.find("nothing to judge"), std::string::npos) << ended.err;
}

TEST(Refusal, OfOneCaseComesBeforeAnotherRuns) {
  const Scratch scratch;
  const std::string file = scratch.file("typo.toml", falling_sphere("density", "densty"));
  const Ended ended = run_program("verify settling " + file + " --engines reference");
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "");
}

TEST(Refusal, OfAStepAboveTheLimitIsLiftedByForce) {
  const Scratch scratch;
  const std::string file = scratch.file("long_step.toml", falling_sphere("\"contact/32\"", "0.02"));
  const Ended refused = run_program("run " + file);
  EXPECT_EQ(refused.code, 2) << refused.err;
  EXPECT_NE(refused.err.find("limit"), std::string::npos) << refused.err;
  EXPECT_NE(run_program("run --force " + file).code, 2);
}

TEST(Help, OfEveryCommandExitsWithZeroAndHasExamples) {
  for (const std::string command : {"verify", "run", "compare", "bench", "doctor"}) {
    const Ended ended = run_program(command + " --help");
    EXPECT_EQ(ended.code, 0);
    EXPECT_NE(ended.out.find("grainproof " + command), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("Exit codes"), std::string::npos);
  }
  EXPECT_EQ(run_program("--help").code, 0);
  EXPECT_EQ(run_program("--version").out.rfind("grainproof ", 0), 0U);
}

}  // namespace
}  // namespace grainproof::testing
