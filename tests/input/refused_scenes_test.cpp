// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

class SceneRefusal : public Refusal {};

TEST_P(SceneRefusal, NamesThePlaceWhatWasFoundAndWhatWasExpected) {
  expect_refused(GetParam());
}

constexpr const char* two = "positions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]";
constexpr const char* floor_plane = "plane = { point = [0.0, 0.0, -0.5], normal = [0.0, 0.0, 1.0] }";

const Mistake geometry[] = {
    {"EmptyDomain", "upper = [1.0, 1.0, 1.0]", "upper = [1.0, -1.0, 1.0]", "upper = [1, -1, 1]",
     "more than lower"},
    {"DomainWallWithoutMaterial", "upper = [1.0, 1.0, 1.0]",
     "upper = [1.0, 1.0, 1.0]\nboundary = [\"wall\", \"open\", \"open\"]", "no \"material\"", "\"material\"",
     "[domain]"},
    {"DomainMaterialWithoutWall", "upper = [1.0, 1.0, 1.0]", "upper = [1.0, 1.0, 1.0]\nmaterial = \"glass\"",
     "material = \"glass\"", "no face", "material = \"glass\""},
    {"ZeroNormal", "normal = [0.0, 0.0, 1.0]", "normal = [0.0, 0.0, 0.0]", "normal = [0, 0, 0]",
     "length above 0"},
    {"PlaneAcrossPeriod", "upper = [1.0, 1.0, 1.0]",
     "upper = [1.0, 1.0, 1.0]\nboundary = [\"open\", \"open\", \"periodic\"]", "across a periodic axis",
     "a normal", floor_plane},
    {"SolidRectangle", floor_plane, "rectangle = { lower = [0.0, 0.0, -0.6], upper = [1.0, 1.0, -0.5] }",
     "upper = [1, 1, -0.5]", "a flat rectangle"},
    {"RectangleWithoutArea", floor_plane,
     "rectangle = { lower = [0.0, 0.0, -0.5], upper = [1.0, 0.0, -0.5] }", "upper = [1, 0, -0.5]",
     "a flat rectangle"},
    {"RectangleInsideOut", floor_plane, "rectangle = { lower = [0.0, 0.0, -0.5], upper = [1.0, -1.0, -0.5] }",
     "upper = [1, -1, -0.5]", "a flat rectangle"},
    {"PlaneAndRectangle", floor_plane,
     "plane = { point = [0.0, 0.0, -0.5], normal = [0.0, 0.0, 1.0] }\n"
     "rectangle = { lower = [0.0, 0.0, -0.5], upper = [1.0, 1.0, -0.5] }",
     "more than one shape", "one of plane, cylinder and rectangle", "[[wall]]"},
    {"WallWithoutShape", floor_plane, "", "neither plane, cylinder nor rectangle", "one of plane",
     "[[wall]]"},
    {"PeriodicBoxTooSmall", "lower = [-1.0, -1.0, -1.0]\nupper = [1.0, 1.0, 1.0]",
     "boundary = [\"periodic\", \"open\", \"open\"]\nlower = [-0.01, -1.0, -1.0]\nupper = [0.18, 1.0, 1.0]",
     "a periodic box 0.19 m wide", "twice the largest particle, 0.2 m", "upper = [0.18"},
};

const Mistake bodies[] = {
    {"OutsideTheDomain", two, "positions = [[0.1, 0.0, 0.0],\n [0.1, 1.5, 0.0]]",
     "particle 3 outside the domain", "domain.lower", "[0.1, 1.5"},
    {"DeepInEachOther", two, "positions = [[0.1, 0.0, 0.0],\n [0.1, 0.07, 0.0]]",
     "particle 3 in particle 2 by 60 %", "half the smaller radius", "[0.1, 0.07"},
    {"DeepInAWall", two, "positions = [[0.1, 0.0, 0.0],\n [0.1, 0.5, -0.48]]",
     "particle 3 in wall floor by 60 %", "half the radius", "[0.1, 0.5, -0.48"},
    {"BehindAWall", two, "positions = [[0.1, 0.0, 0.0],\n [0.1, 0.5, -0.7]]", "in wall floor",
     "half the radius", "[0.1, 0.5, -0.7"},
    {"SameIdTwice", two, "positions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]\nids = [7,\n 7]",
     "id 7 a second time", "different id", " 7]"},
    {"IdOfAnotherTable", two, "positions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]\nids = [1, 2]",
     "id 1 a second time", "different id", "ids"},
    {"IdOfZero", two, "positions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]\nids = [0, 1]", "ids = 0", "from 1",
     "ids"},
    {"FewerIdsThanPositions", two, "positions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]\nids = [4]", "ids of 1",
     "each of the 2", "ids"},
    {"FewerVelocitiesThanPositions", "velocities = [[-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]",
     "velocities = [[-2.0, 0.0, 0.0]]", "velocities of 1", "each of the 2"},
    {"FlatPositions", two, "positions = [0.1, 0.0, 0.0]", "positions = 0.1", "[x, y, z]"},
    {"NoPositions", two, "positions = []", "an array of 0", "at least one"},
    {"FixedButMoving", "fixed = true", "fixed = true\nvelocities = [[1.0, 0.0, 0.0]]", "an array of 3",
     "fixed particles never move", "velocities = [[1"},
    {"PositionsAndFill", two, "positions = [[0.1, 0.0, 0.0]]\nfill = { kind = \"lattice\" }",
     "both positions and fill", "one of the two", "fill"},
};

const Mistake contacts[] = {
    {"PairWithoutLaws", "between = [\"glass\", \"glass\"]", "between = [\"steel\", \"steel\"]", "no contact",
     "[\"glass\", \"glass\"]", "material = \"glass\"\ndiameter = 0.1\nfixed"},
    {"WallPairWithoutLaws", "between = [\"glass\", \"steel\"]", "between = [\"steel\", \"steel\"]",
     "no contact", "[\"glass\", \"steel\"]", "material = \"glass\"\ndiameter = 0.1\nfixed"},
    {"PairTwice", "between = [\"glass\", \"steel\"]", "between = [\"glass\", \"glass\"]", "again", "once",
     "between = [\"glass\", \"glass\"]\nnormal = { law = \"linear\", stiffness = 1e6"},
    {"OneName", "between = [\"glass\", \"steel\"]", "between = [\"glass\"]", "an array of 1",
     "two materials"},
    {"StepAboveTheStabilityLimit", "step = \"contact/64\"", "step = 5e-3", "a step of 0.005 s",
     "bodies of glass and glass with up to 3 contacts at once"},
};

INSTANTIATE_TEST_SUITE_P(Geometry, SceneRefusal, ::testing::ValuesIn(geometry), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Bodies, SceneRefusal, ::testing::ValuesIn(bodies), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Contacts, SceneRefusal, ::testing::ValuesIn(contacts), name_of_mistake);

TEST(Refusals, AFileThatIsNotThereIsNamed) {
  try {
    read_case("scenes/none.toml");
    FAIL() << "read a file that is not there";
  } catch (const InputRefused& refused) {
    EXPECT_TRUE(std::string(refused.what()).starts_with("scenes/none.toml:1:1: found no file"));
  }
}

TEST(Refusals, TheColumnIsThatOfTheValue) {
  const std::string message =
      refusal_of(example_with("lower = [-1.0, -1.0, -1.0]", "lower = [-1.0, nan, -1.0]"));
  EXPECT_TRUE(message.starts_with("scene.toml:9:16:")) << message;
}

TEST(Refusals, ExampleItselfIsRead) {
  EXPECT_EQ(read_text(example).scenes.size(), 1u);
}

}  // namespace
}  // namespace grainproof
