// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

TEST_P(Refusal, NamesThePlaceWhatWasFoundAndWhatWasExpected) {
  expect_refused(GetParam());
}

constexpr const char* glass_law = "{ law = \"linear\", stiffness = 1e5, restitution = 0.8 }";

const Mistake words[] = {
    {"SyntaxError", "end = 0.01", "end = = 0.01", "syntax error", "TOML"},
    {"NotUtf8", "Example", "Exam\xff", "syntax error", "TOML"},
    {"UnknownTable", "[run]", "[runs]\nend = 1.0\n[run]", "unknown key \"runs\"", "\"run\"", "[runs]"},
    {"UnknownKey", "density = 2000.0", "denisty = 2000.0", "unknown key \"denisty\" in glass", "\"density\""},
    {"UnknownKeyFarFromAll", "density = 2000.0", "density = 1.0\nwatermelon = 1", "\"watermelon\"",
     "\"density\"", "watermelon"},
    {"UnknownKeyInLaw", "stiffness = 1e5,", "stiffnes = 1e5,", "unknown key \"stiffnes\"", "\"stiffness\""},
    {"UnknownNormalLaw", "law = \"linear\", stiffness = 1e5", "law = \"walton\", stiffness = 1e5",
     "\"walton\"", "\"linear\" or \"hertz\""},
    {"UnknownFrictionLaw", glass_law,
     "{ law = \"linear\", stiffness = 1e5, restitution = 0.8 }\nfriction = { law = \"steps\", coefficient = "
     "1 }",
     "law = \"steps\"", "\"step\"", "friction"},
    {"UnknownIntegrator", "end = 0.01", "integrator = \"velocity_verlett\"\nend = 0.01", "velocity_verlett",
     "\"velocity_verlet\""},
    {"UnknownOrder", "end = 0.01", "order = \"slow\"\nend = 0.01", "slow", "\"fast\" or \"canonical\""},
    {"UnknownNeighbours", "end = 0.01", "neighbours = \"cell\"\nend = 0.01", "cell", "\"cells\""},
    {"UnknownBoundary", "lower = [-1", "boundary = [\"open\", \"open\", \"closed\"]\nlower = [-1", "closed",
     "\"open\", \"periodic\" or \"wall\""},
    {"UnknownGravity", "gravity = [0.0, 0.0, -9.81]", "gravity = { kind = \"rotatin\" }", "rotatin",
     "\"rotating\""},
    {"UnknownFlow", "gravity = [0.0, 0.0, -9.81]", "flow = { kind = \"tailor_green\" }", "tailor_green",
     "\"taylor_green\""},
    {"UnknownMaterial", "material = \"steel\"", "material = \"steal\"", "steal", "\"steel\""},
    {"UnknownFill", "positions = [[0.0, 0.0, 0.0]]", "fill = { kind = \"grid\" }", "grid", "\"lattice\""},
    {"NoSchema", "schema = 1", "", "no \"schema\"", "schema"},
    {"OtherSchema", "schema = 1", "schema = 2", "schema = 2", "1 to 1"},
    {"NoRun", "[run]", "[bodies]", "no \"run\"", "\"run\"", "schema = 1"},
    {"NoStep", "step = \"contact/64\"", "", "no \"step\"", "\"step\"", "[run]"},
    {"NoDensity", "density = 2000.0", "", "no \"density\" in glass", "\"density\"", "[material.glass]"},
    {"RotationInWords", "[field]", "[bodies]\nrotation = \"on\"\n[field]", "rotation = \"on\"",
     "true or false", "rotation"},
};

const Mistake types[] = {
    {"TextForNumber", "end = 0.01", "end = \"0.01\"", "end = \"0.01\"", "a number"},
    {"NumberForText", "title = \"Example\"", "title = 3", "title = 3", "text"},
    {"NumberForBoolean", "fixed = true", "fixed = 1", "fixed = 1", "true or false"},
    {"FractionForWhole", "schema = 1", "schema = 1.0", "schema = 1", "a whole number"},
    {"TwoNumbersForThree", "lower = [-1.0, -1.0, -1.0]", "lower = [-1.0, -1.0]", "an array of 2",
     "three numbers"},
    {"TextInVector", "lower = [-1.0, -1.0, -1.0]", "lower = [-1.0, -1.0, \"-1\"]", "\"-1\"", "a number"},
    {"TableForArray", "positions = [[0.0, 0.0, 0.0]]", "positions = { x = 0.0 }", "a table", "an array"},
    {"ArrayForTable", "[material.glass]\ndensity = 2000.0", "[material]\nglass = [2000.0]", "an array",
     "a table", "glass = ["},
    {"SingleTableForTables", "[[wall]]", "[wall]", "a table", "write [[wall]]"},
    {"DateForNumber", "end = 0.01", "end = 1979-05-27", "a date", "a number"},
    {"NotANumber", "end = 0.01", "end = nan", "end = nan", "a finite number"},
    {"Infinite", "diameter = 0.1\nfixed", "diameter = inf\nfixed", "diameter = inf", "a finite number",
     "diameter = inf"},
    {"NotANumberInPosition", "[[0.0, 0.0, 0.0]]", "[[0.0, nan, 0.0]]", "nan", "a finite number"},
    {"InfiniteGravity", "-9.81]", "-inf]", "-inf", "a finite number"},
};

const Mistake numbers[] = {
    {"EndOfZero", "end = 0.01", "end = 0.0", "end = 0", "above 0"},
    {"NegativeEnd", "end = 0.01", "end = -1.0", "end = -1", "above 0"},
    {"NegativeStep", "step = \"contact/64\"", "step = -1e-5", "step = -1e-05", "above 0"},
    {"ZeroStep", "step = \"contact/64\"", "step = 0", "step = 0", "above 0"},
    {"NoFractionOfContact", "contact/64", "contact/", "contact/", "contact/N"},
    {"TextAfterFraction", "contact/64", "contact/64s", "contact/64s", "contact/N"},
    {"StepOfNothing", "contact/64", "contact/nan", "contact/nan", "contact/N"},
    {"OtherFraction", "contact/64", "period/64", "period/64", "contact/N"},
    {"NegativeDensity", "density = 2000.0", "density = -2000.0", "density = -2000", "above 0"},
    {"ZeroDensity", "density = 2000.0", "density = 0.0", "density = 0", "above 0"},
    {"NegativeDiameter", "diameter = 0.1\nfixed", "diameter = -0.1\nfixed", "diameter = -0.1", "above 0",
     "diameter = -0.1"},
    {"MassUnderflows", "diameter = 0.1\nfixed", "diameter = 1e-120\nfixed", "1e-120", "mass", "1e-120"},
    {"NegativeStiffness", "stiffness = 1e5", "stiffness = -1e5", "stiffness = -1e+05", "above 0"},
    {"ZeroStiffness", "stiffness = 1e5", "stiffness = 0", "stiffness = 0", "above 0"},
    {"RestitutionAboveOne", "restitution = 0.8", "restitution = 1.01", "restitution = 1.01", "from 0 to 1"},
    {"NegativeRestitution", "restitution = 0.8", "restitution = -0.1", "restitution = -0.1", "from 0 to 1"},
    {"RestitutionAndDamping", "restitution = 0.8", "restitution = 0.8, damping = 1.0", "damping = 1",
     "not both"},
    {"NeitherRestitutionNorDamping", ", restitution = 0.8", "", "no \"restitution\"", "\"restitution\"",
     "stiffness = 1e5"},
    {"NegativeDamping", "restitution = 0.8", "damping = -1.0", "damping = -1", "positive"},
    {"NoReboundWithoutTension", "restitution = 0.8", "restitution = 0.0, no_tension = true",
     "restitution = 0", "always rebounds"},
    {"NegativeFriction", glass_law,
     "{ law = \"linear\", stiffness = 1e5, restitution = 0.8 }\nfriction = { law = \"none\", coefficient = "
     "-0.1 }",
     "coefficient = -0.1", "positive", "friction"},
    {"StiffnessOfDynamicFriction", glass_law,
     "{ law = \"linear\", stiffness = 1e5, restitution = 0.8 }\n"
     "friction = { law = \"none\", coefficient = 1, stiffness = 1 }",
     "unknown key \"stiffness\"", "\"coefficient\"", "friction"},
    {"NegativeCohesion", glass_law,
     "{ law = \"linear\", stiffness = 1e5, restitution = 0.8 }\ncohesion = { law = \"linear\", stiffness = "
     "-1.0 }",
     "stiffness = -1", "above 0", "cohesion"},
    {"EffectDiameterBelowBody", "diameter = 0.1\nfixed", "diameter = 0.1\neffect_diameter = 0.09\nfixed",
     "effect_diameter = 0.09", "at least the body's diameter, 0.1", "effect_diameter"},
    {"NegativeViscosity", "gravity = [0.0, 0.0, -9.81]", "flow = { kind = \"still\", viscosity = -1.0 }",
     "viscosity = -1", "above 0"},
    {"NegativeSkin", "end = 0.01", "skin = -0.1\nend = 0.01", "skin = -0.1", "positive"},
    {"SkinOfAnotherName", "end = 0.01", "skin = \"wide\"\nend = 0.01", "\"wide\"", "\"auto\"", "skin"},
    {"RecordTwice", "end = 0.01", "record = { every = 0.1, steps = 3 }\nend = 0.01", "a table",
     "one of every"},
    {"RecordNever", "end = 0.01", "record = { steps = 0 }\nend = 0.01", "steps = 0", "from 1"},
    {"TooManyFrames", "end = 0.01", "record = { every = 1e-12 }\nend = 0.01", "a million frames", "record",
     "step = "},
    {"OverlapLimitWhereCentresMeet", "end = 0.01", "overlap_limit = 2.0\nend = 0.01", "overlap_limit = 2",
     "below 2"},
    {"StrideBeyondARadius", "step = \"contact/64\"", "step = 0.1\nbeyond_stability = true",
     "particle 2 moving by 4 radii in a step", "at most its radius", "step ="},
    {"StrideOfARectangle", "plane = { point = [0.0, 0.0, -0.5], normal = [0.0, 0.0, 1.0] }",
     "rectangle = { lower = [-1.0, -1.0, -0.5], upper = [1.0, 1.0, -0.5] }\nmotion = { velocity = [1e4, 0.0, "
     "0.0] }",
     "wall floor moving by", "the smallest radius of what it may hit, 0.05 m", "step ="},
    {"TooManySteps", "step = \"contact/64\"", "step = 1e-20", "steps", "1e15"},
};

INSTANTIATE_TEST_SUITE_P(Words, Refusal, ::testing::ValuesIn(words), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Types, Refusal, ::testing::ValuesIn(types), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Numbers, Refusal, ::testing::ValuesIn(numbers), name_of_mistake);

}  // namespace
}  // namespace grainproof
