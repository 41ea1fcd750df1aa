// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/step_for_error.hpp"
#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

const std::string by_error = example_with("step = \"contact/64\"", "step = { error = 2e-3 }");

TEST(StepByError, IsResolvedFromTheScenesLawsAndIntegrator) {
  const Case read = read_text(by_error);
  ASSERT_EQ(read.scenes.size(), 1u);
  const ResolvedScene& one = read.scenes.front();
  EXPECT_EQ(one.point.step, "error/0.002");
  EXPECT_EQ(one.scene.run.step, analytic::step_for_error(one.scene, 2e-3).step);
  EXPECT_NE(one.point.step_because.find("onset_corrected"), std::string::npos) << one.point.step_because;
}

TEST(StepByError, HasNoReasonWhereTheSceneSaysTheStep) {
  EXPECT_EQ(read_text(example).scenes.front().point.step_because, "");
}

TEST(StepByError, IsSmallerForASmallerErrorAndForALessAccurateIntegrator) {
  const Case read = read_text(example +
                              "\n[sweep]\nstep = [{ error = 1e-2 }, { error = 1e-3 }]\n"
                              "integrator = [\"velocity_verlet\", \"euler_trapezoid\"]\n");
  ASSERT_EQ(read.scenes.size(), 4u);
  const auto step = [&](std::size_t i) { return read.scenes[i].scene.run.step; };
  EXPECT_LT(step(1), 0.3 * step(0));
  EXPECT_LT(step(2), 0.3 * step(0));
  EXPECT_LT(step(3), 0.3 * step(2));
}

const Mistake mistakes[] = {
    {"NoError", "{ error = 2e-3 }", "{}", "no \"error\"", "error", "step = {}"},
    {"UnknownKey", "{ error = 2e-3 }", "{ eror = 2e-3 }", "unknown key \"eror\"", "\"error\""},
    {"ErrorOfZero", "error = 2e-3", "error = 0.0", "error = 0", "1e-09"},
    {"ErrorOfOne", "error = 2e-3", "error = 1.0", "error = 1", "0.5"},
    {"Cohesion", "restitution = 0.8 }",
     "restitution = 0.8 }\ncohesion = { law = \"linear\", stiffness = 1.0 }", "a step by its error",
     "cohesion", "error = 2e-3"},
    {"Friction", "restitution = 0.8 }",
     "restitution = 0.8 }\nfriction = { law = \"step\", coefficient = 0.5, stiffness = 1e5 }",
     "a step by its error", "friction", "error = 2e-3"},
    {"RestitutionBelowTheMeasured", "restitution = 0.8 }", "restitution = 0.1 }", "a step by its error",
     "restitution 0.1", "error = 2e-3"},
};

class StepByErrorRefusal : public ::testing::TestWithParam<Mistake> {};

TEST_P(StepByErrorRefusal, NamesThePlaceAndTheReason) {
  expect_refused(GetParam(), by_error);
}

INSTANTIATE_TEST_SUITE_P(StepByError, StepByErrorRefusal, ::testing::ValuesIn(mistakes), name_of_mistake);

}  // namespace
}  // namespace grainproof
