// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/claims.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "report/results_json.hpp"
#include "report/verdict_text.hpp"
#include "tests/app/rows.hpp"

namespace grainproof::testing {
namespace {

using report::read_together;

const std::vector<Row> rows{step_row("reference", "contact/8", 0.1, 0.2),
                            step_row("reference", "contact/16", 0.05, 0.075),
                            step_row("reference", "contact/32", 0.025, 0.05),
                            order_row("reference", 1.02),
                            step_row("opencl:single", "contact/8", 0.1, 0.2),
                            step_row("opencl:single", "contact/16", 0.09, 0.075),
                            step_row("opencl:single", "contact/32", 0.025, 0.05),
                            order_row("opencl:single", 0.5),
                            unsupported_row("liggghts", "no such scheme")};

TEST(Claims, PutStepsAndOrderOfOneEngineOnOneLine) {
  const auto together = read_together(rows);
  ASSERT_EQ(together.claims.size(), 1U);
  ASSERT_EQ(together.claims[0].lines.size(), 2U);
  EXPECT_EQ(together.claims[0].lines[0].steps.size(), 3U);
  EXPECT_EQ(together.claims[0].steps, (std::vector<std::string>{"contact/8", "contact/16", "contact/32"}));
  EXPECT_EQ(together.claims[0].samples, 256);
  EXPECT_EQ(together.unsupported, std::vector<std::string>{"liggghts: no such scheme"});
}

TEST(Claims, FailALineOfWhichOneStepFailed) {
  const auto together = read_together(rows);
  EXPECT_EQ(together.claims[0].lines[0].verdict(), Verdict::pass);
  EXPECT_EQ(together.claims[0].lines[1].verdict(), Verdict::fail);
}

TEST(Claims, TakeTheSmallestMarginOfAllSteps) {
  EXPECT_DOUBLE_EQ(read_together(rows).claims[0].lines[0].margin().value(), 1.5);
}

TEST(Claims, HaveAnInfiniteMarginWithoutAnError) {
  EXPECT_TRUE(std::isinf(
      read_together({step_row("reference", "contact/8", 0.0, 0.0)}).claims[0].lines[0].margin().value()));
}

TEST(Claims, HaveNoMarginWhereNoNumberExists) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(read_together({step_row("reference", "contact/8", nan, 0.2)}).claims[0].lines[0].margin());
}

TEST(VerdictText, ShowsErrorsOrderMarginAndVerdictOfEveryEngine) {
  EXPECT_EQ(report::case_text(rows, "A sphere bounces", {}),
            "bounce  A sphere bounces  FAIL\n"
            "  restitution, rms of 256, against closed_form:bounce; errors relative to the exact value; the "
            "approach "
            "speed where that is zero\n"
            "    engine         integrator       error at contact/8  error at contact/16  error at "
            "contact/32  order  "
            "expected  tolerance/error  verdict\n"
            "    reference      velocity_verlet                 0.1                 0.05                "
            "0.025   1.02   "
            "1 ± 0.1            1.5 ×  pass\n"
            "    opencl:single  velocity_verlet                 0.1                 0.09                "
            "0.025   0.50   "
            "1 ± 0.1          0.833 ×  FAIL\n"
            "  not supported  liggghts: no such scheme\n\n");
}

TEST(VerdictText, ExplainsEveryFailureWithWhatWasExpected) {
  const std::string text = report::failures_text(rows, {});
  EXPECT_NE(text.find("bounce, opencl:single, velocity_verlet, step contact/16\n"
                      "      restitution against closed_form:bounce: error 0.09, expected at most 0.075"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("from contact/8 to contact/32, expected 1 ± 0.1"), std::string::npos) << text;
  EXPECT_EQ(text.find("reference, velocity"), std::string::npos) << text;
}

TEST(VerdictText, CountsVerdictsByCaseAndEngine) {
  EXPECT_EQ(report::summary_text(rows, 61.0, {}),
            "case    reference  opencl:single  liggghts\n"
            "bounce  pass 4     FAIL 2 of 4    unsupported\n\n"
            "6 passed, 2 failed, 1 not supported; 1 min 01 s\n");
}

TEST(ResultsJson, GivesAStepOrAnOrderAndNullForWhatDoesNotExist) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto json =
      report::results_json({step_row("reference", "contact/8", nan, 0.2), order_row("reference", 1.02)}, {});
  EXPECT_TRUE(json["results"][0]["error"].is_null());
  EXPECT_EQ(json["results"][0]["verdict"], "fail");
  EXPECT_EQ(json["results"][0]["step"], "contact/8");
  EXPECT_TRUE(json["results"][0]["order"].is_null());
  EXPECT_TRUE(json["results"][1]["step"].is_null());
  EXPECT_EQ(json["results"][1]["order"], 1.02);
}

}  // namespace
}  // namespace grainproof::testing
