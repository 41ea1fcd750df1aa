// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

class SweepRefusal : public Refusal {};

TEST_P(SweepRefusal, NamesThePlaceWhatWasFoundAndWhatWasExpected) {
  expect_refused(GetParam());
}

constexpr const char* end = "gravity = [0.0, 0.0, -9.81]";

/// Everything stands behind the last line of the example.
#define AFTER(text) end, "gravity = [0.0, 0.0, -9.81]\n" text

const Mistake sweeps[] = {
    {"NoKey", AFTER("[sweep]"), "an empty sweep", "at least one key", "[sweep]"},
    {"NoSteps", AFTER("[sweep]\nstep = []"), "an array of 0", "at least one", "step = []"},
    {"NoPhases", AFTER("[sweep]\nonset = { phases = 0, at = \"body\" }"), "phases = 0", "from 1", "onset"},
    {"NoOrientations", AFTER("[sweep]\norientation = 0"), "orientation = 0", "from 1", "orientation = 0"},
    {"NoValues", AFTER("[sweep]\n\"run.end\" = []"), "an array of 0", "at least one", "run.end"},
    {"StepOfText", AFTER("[sweep]\nstep = [\"tiny\"]"), "tiny", "contact/N", "tiny"},
    {"UnknownKey", AFTER("[sweep]\nsteps = [1e-5]"), "sweep key \"steps\"", "\"step\"", "steps"},
    {"PathToNothing", AFTER("[sweep]\n\"contact.9.normal.stiffness\" = [1e5]"), "leads to no number", "path",
     "contact.9"},
    {"PathToText", AFTER("[sweep]\n\"wall.0.name\" = [1]"), "leads to no number", "path", "wall.0"},
    {"PathToStep", AFTER("[sweep]\n\"run.step\" = [1e-5]"), "leads to no number", "\"step\"", "run.step"},
    {"PathOutOfTheScene", AFTER("[sweep]\n\"schema\" = [1]"), "leads to no number", "path", "\"schema\""},
    {"ValueOfText", AFTER("[sweep]\n\"run.end\" = [\"long\"]"), "long", "a number", "long"},
    {"ValueThatTheSceneRefuses", AFTER("[sweep]\n\"contact.0.normal.restitution\" = [0.8,\n 1.5]"),
     "restitution = 1.5", "from 0 to 1", " 1.5"},
    {"UnknownIntegrator", AFTER("[sweep]\nintegrator = [\"euler\"]"), "euler", "\"euler_trapezoid\"",
     "\"euler\""},
    {"DitherAlone", AFTER("[sweep]\nstep_dither = true"), "step_dither = true", "onset or orientation",
     "step_dither"},
    {"DitherOfSeconds", AFTER("[sweep]\nstep = [1e-5]\nstep_dither = true\norientation = 2"), "step = 1e-05",
     "contact/N", "step = [1e-5]"},
    {"OnsetWithoutTouch",
     AFTER("[sweep]\nonset = { phases = 4, at = \"effect\" }\n"
           "\"particles.1.positions.0.0\" = [0.11]"),
     "no surfaces touch", "effect surfaces that touch", "onset"},
    {"OnsetAtNoSurface", AFTER("[sweep]\nonset = { phases = 4, at = \"skin\" }"), "skin",
     "\"body\" or \"effect\"", "onset"},
    {"OffsetOfTwo", AFTER("[sweep]\noffset = [[1.0, 0.0]]"), "an array of 2", "three numbers", "offset"},
    {"OffsetInRadii", AFTER("[sweep]\noffset = [{ radii = [1.0, 0.0, 0.0] }]"), "radii", "diameters",
     "offset"},
    {"ScaleOfZero", AFTER("[sweep]\nscale = [0.0]"), "0", "a number above 0", "scale"},
    {"OffsetOfVortices",
     AFTER("flow = { kind = \"taylor_green\", viscosity = 1e-5, amplitude = 1, wave_number = 1 }\n"
           "[sweep]\noffset = [[1.0, 0.0, 0.0]]"),
     "bound to the origin", "uniform", "offset"},
    {"TooManyScenes", AFTER("[sweep]\norientation = 20001"), "a sweep over 20001 scenes", "at most 20000",
     "[sweep]"},
    {"TooManyScenesInAll",
     AFTER("[sweep]\nstep = [1e-5, 2e-5, 3e-5]\norientation = 900000\n"
           "offset = [[0, 0, 0], [1, 0, 0]]\nonset = { phases = 999999, at = \"body\" }"),
     "5399994600000 scenes", "at most 20000", "[sweep]"},
};

const Mistake rotations[] = {
    {"OfRectangles", "plane = { point = [0.0, 0.0, -0.5], normal = [0.0, 0.0, 1.0] }",
     "rectangle = { lower = [0.0, 0.0, -0.5], upper = [1.0, 1.0, -0.5] }\n[sweep]\norientation = 2",
     "the rectangle floor", "planes", "orientation"},
    {"OfPeriods", "upper = [1.0, 1.0, 1.0]",
     "upper = [1.0, 1.0, 1.0]\nboundary = [\"periodic\", \"open\", \"open\"]\n[sweep]\norientation = 2",
     "a domain that is not open", "open", "orientation"},
    {"OfTurningGravity", "gravity = [0.0, 0.0, -9.81]",
     "gravity = { kind = \"rotating\", magnitude = 9.81 }\n[sweep]\norientation = 2", "bound to the axes",
     "constant", "orientation"},
    {"OutOfTheDomain", "upper = [1.0, 1.0, 1.0]", "upper = [1.0, 1.0, -0.499]\n[sweep]\norientation = 2",
     "outside the domain", "domain.lower", "[0.0, 0.0, 0.0]]"},
};

const Mistake expectations[] = {
    {"OfNothing", AFTER("[[expect]]\nquantity = \"velocity\"\nagainst = \"value:1\""), "nothing",
     "below, order or sign", "[[expect]]"},
    {"WithoutQuantity", AFTER("[[expect]]\nbelow = 1.0"), "no \"quantity\"", "\"quantity\"", "[[expect]]"},
    {"UnknownKey", AFTER("[[expect]]\nquantitiy = \"velocity\""), "\"quantitiy\"", "\"quantity\"",
     "quantitiy"},
    {"AgainstNothing", AFTER("[[expect]]\nquantity = \"velocity\"\nagainst = \"reference\"\nbelow = 1"),
     "reference", "engine:NAME", "against"},
    {"UnknownStatistic",
     AFTER("[[expect]]\nquantity = \"velocity\"\nagainst = \"value:1\"\nstatistic = \"median\""), "median",
     "\"mean\"", "median"},
    {"SignOfZero", AFTER("[[expect]]\nquantity = \"velocity\"\nagainst = \"value:1\"\nsign = 0"), "sign = 0",
     "-1 or 1", "sign"},
    {"NegativeBound", AFTER("[[expect]]\nquantity = \"velocity\"\nagainst = \"value:1\"\nbelow = -1e-3"),
     "below = -0.001", "positive", "below"},
    {"StepThatIsNotSwept",
     AFTER("[[expect]]\nquantity = \"velocity\"\nagainst = \"value:1\"\nbelow = { \"contact/63\" = 1 }"),
     "\"contact/63\"", "as the sweep", "[[expect]]"},
    {"OrderOfAStepThatIsNotSwept",
     AFTER("[[expect]]\nquantity = \"velocity\"\nagainst = \"value:1\"\n"
           "order = { from = \"contact/8\", to = \"contact/64\", is = 1, within = 1 }"),
     "\"contact/8\"", "as the sweep", "[[expect]]"},
    {"PointThatIsNotSwept",
     AFTER("[[expect]]\nfor = { offset = [1.0, 0.0, 0.0] }\nquantity = \"velocity\"\n"
           "against = \"value:1\"\nbelow = 1"),
     "a point that the sweep doesn't have", "swept", "[[expect]]"},
    {"UnknownOutcome", AFTER("[[expect]]\noutcome = \"refuse\"\nreason = \"\""), "refuse", "\"refused\"",
     "outcome"},
    {"OutcomeWithoutReason", AFTER("[[expect]]\noutcome = \"refused\""), "no \"reason\"", "\"reason\"",
     "[[expect]]"},
    {"EnginesOfNone",
     AFTER("[[expect]]\nquantity = \"velocity\"\nagainst = \"value:1\"\nbelow = 1\nengines = []"),
     "an array of 0", "at least one", "engines"},
    {"UnknownClosedForm",
     AFTER("[[expect]]\nquantity = \"velocity\"\nbelow = 1\nagainst = \"closed_form:free_fal\""), "free_fal",
     "\"free_fall\"", "\"closed_form"},
    {"ValueOfNoNumber", AFTER("[[expect]]\nquantity = \"velocity\"\nbelow = 1\nagainst = \"value:1 m\""),
     "value:1 m", "value:NUMBER", "\"value"},
    {"InvariantOfAnotherQuantity",
     AFTER("[[expect]]\nquantity = \"energy\"\nbelow = 1\nagainst = \"invariant:momentum\""), "momentum",
     "\"energy\"", "\"invariant"},
    {"UnknownVerifyKey", AFTER("[verify]\nno_peer = \"none\""), "\"no_peer\"", "\"no_peers\"", "no_peer"},
};

#undef AFTER

INSTANTIATE_TEST_SUITE_P(Sweeps, SweepRefusal, ::testing::ValuesIn(sweeps), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Rotations, SweepRefusal, ::testing::ValuesIn(rotations), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Expectations, SweepRefusal, ::testing::ValuesIn(expectations), name_of_mistake);

TEST(Refusals, ASweepIsRefusedBeforeItsParticlesFillTheMemory) {
  const std::string text =
      example_with("positions = [[0.0, 0.0, 0.0]]",
                   "fill = { kind = \"lattice\", counts = [10, 10, 10], origin = [-0.9, -0.9, -0.4], "
                   "spacing = 0.05 }") +
      "[sweep]\norientation = 20000\n";
  EXPECT_NE(refusal_of(with(text, "diameter = 0.1\nfixed", "diameter = 0.01\nfixed"))
                .find("a sweep over 20040000 particles in all; expected at most 20000000"),
            std::string::npos);
}

TEST(Refusals, ACaseThatExpectsToBeRefusedHoldsTheMessage) {
  const std::string expected = "\n[[expect]]\noutcome = \"refused\"\nreason = \"stability limit\"\n";
  const Case read = read_text(example_with("step = \"contact/64\"", "step = 5e-3") + expected);
  EXPECT_TRUE(read.scenes.empty());
  EXPECT_NE(read.refused.find("scene.toml:6:8: found a step of 0.005 s above the stability limit"),
            std::string::npos)
      << read.refused;
}

TEST(Refusals, ACaseThatExpectsToBeRefusedAndIsNotHasItsScenes) {
  const Case read =
      read_text(example + "\n[[expect]]\noutcome = \"refused\"\nreason = \"stability limit\"\n");
  EXPECT_EQ(read.scenes.size(), 1u);
  EXPECT_EQ(read.refused, "");
}

TEST(Refusals, AnIntegratorThatNoStepMakesStableIsSaidToBeSo) {
  const std::string elastic = with(example_with("restitution = 0.8", "restitution = 1.0"), "end = 0.01",
                                   "integrator = \"euler_trapezoid\"\nend = 0.01");
  EXPECT_NE(
      refusal_of(elastic).find("expected another integrator, since no step is stable (normal contact of "
                               "glass and glass"),
      std::string::npos)
      << refusal_of(elastic);
}

TEST(Refusals, ForceAndTheSceneItselfPermitAStepAboveTheLimit) {
  const std::string bold = example_with("step = \"contact/64\"", "step = 5e-3");
  EXPECT_NE(refusal_of(bold), "");
  EXPECT_EQ(refusal_of(bold, {.force = true}), "");
  EXPECT_EQ(refusal_of(with(bold, "step = 5e-3", "step = 5e-3\nbeyond_stability = true")), "");
}

}  // namespace
}  // namespace grainproof
