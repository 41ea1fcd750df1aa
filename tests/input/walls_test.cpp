// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

const std::string floor_plane = "plane = { point = [0.0, 0.0, -0.5], normal = [0.0, 0.0, 1.0] }";
const std::string drum =
    "cylinder = { point = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 2.0], radius = 0.8, side = \"inside\" }";

/// The example in a drum instead of over a floor, periodic along it.
std::string in_a_drum(const std::string& more = "") {
  const std::string periodic =
      with(example, "lower = [-1", "boundary = [\"open\", \"open\", \"periodic\"]\nlower = [-1");
  return with(periodic, floor_plane, drum + more);
}

const WallMotion& motion_of(const std::string& text, std::size_t scene = 0) {
  static Case read;
  read = read_text(text);
  return read.scenes.at(scene).scene.walls.at(0).motion;
}

TEST(Walls, ACylinderHasAnAxisOfUnitLengthAndStandsStill) {
  const Scene scene = read_text(in_a_drum()).scenes.at(0).scene;
  const auto& cylinder = std::get<Cylinder>(scene.walls.at(0).shape);
  EXPECT_EQ(cylinder.axis, Vec3(0, 0, 1));
  EXPECT_EQ(cylinder.radius, 0.8);
  EXPECT_EQ(cylinder.side, Cylinder::Side::inside);
  EXPECT_TRUE(std::holds_alternative<Still>(scene.walls[0].motion));
}

TEST(Walls, MotionsAreReadKeyByKey) {
  const auto& along = std::get<Translating>(
      motion_of(example_with(floor_plane, floor_plane + "\nmotion = { velocity = [0.1, 0.2, 0.3] }")));
  EXPECT_EQ(along.velocity, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(std::get<Rotating>(motion_of(in_a_drum("\nmotion = { rate = -3.5 }"))).rate, -3.5);
  const auto& vibrating = std::get<Vibrating>(motion_of(example_with(
      floor_plane,
      floor_plane + "\nmotion = { amplitude = [0.0, 0.0, 1e-4], frequency = 20.0, phase = 0.5 }")));
  EXPECT_EQ(vibrating.amplitude, Vec3(0, 0, 1e-4));
  EXPECT_EQ(vibrating.frequency, 20.0);
  EXPECT_EQ(vibrating.phase, 0.5);
}

TEST(Walls, OrientationTurnsCylindersAndMotionsWithTheScene) {
  const std::string still = with(example, floor_plane, drum + "\nmotion = { velocity = [0.0, 0.0, 0.4] }");
  const Case read = read_text(still + "\n[sweep]\norientation = 4\n");
  for (const ResolvedScene& resolved : read.scenes) {
    const Wall& wall = resolved.scene.walls.at(0);
    const Vec3& axis = std::get<Cylinder>(wall.shape).axis;
    EXPECT_LT((std::get<Translating>(wall.motion).velocity - 0.4 * axis).norm(), 1e-15);
    EXPECT_NEAR(std::abs(std::get<ConstantGravity>(resolved.scene.gravity).acceleration.dot(axis)), 9.81,
                1e-14);
  }
}

TEST(Walls, OffsetTakesCylindersAlong) {
  const Case read = read_text(with(example, floor_plane, drum) + "\n[sweep]\noffset = [[1.0, 2.0, 3.0]]\n");
  EXPECT_EQ(std::get<Cylinder>(read.scenes.at(0).scene.walls.at(0).shape).point, Vec3(1, 2, 3));
}

/// A Hertz contact is as quick as its wall comes.
TEST(Walls, AMovingWallCountsInTheClosingSpeedOfHertzContacts) {
  std::string text =
      with(example, "density = 2000.0", "density = 2000.0\nyoungs_modulus = 1e8\npoisson_ratio = 0.2");
  text = with(text, "density = 7800.0", "density = 7800.0\nyoungs_modulus = 1e8\npoisson_ratio = 0.2");
  text = with(text, "law = \"linear\", stiffness = 1e6,", "law = \"hertz\",");
  text = with(text, "law = \"linear\", stiffness = 1e5,", "law = \"hertz\",");
  const auto step_with = [&](const std::string& motion) {
    return read_text(with(text, floor_plane, floor_plane + motion)).scenes.at(0).scene.run.step;
  };
  // At 2 m/s, which one sphere has, two free spheres are the shortest: (1/2)^(1/5) of the floor's duration,
  // which halves as v^(-1/5) at 64 m/s.
  EXPECT_NEAR(step_with("\nmotion = { velocity = [0.0, 0.0, 62.0] }") / step_with(""),
              0.5 * std::pow(2.0, 0.2), 1e-14);
}

class WallRefusal : public Refusal {};

TEST_P(WallRefusal, NamesThePlaceWhatWasFoundAndWhatWasExpected) {
  expect_refused(GetParam(), in_a_drum("\nmotion = { rate = 1.0 }"));
}

constexpr const char* motion = "motion = { rate = 1.0 }";
constexpr const char* shape =
    "cylinder = { point = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 2.0], radius = 0.8, side = \"inside\" }";

constexpr const char* turning_shape =
    "cylinder = { point = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 2.0], radius = 0.8, side = \"inside\" }\n"
    "motion = { rate = 1.0 }";

const Mistake shapes[] = {
    {"CylinderSmallerThanAParticle", "radius = 0.8", "radius = 0.049",
     "radius 0.049 m around a particle of radius 0.05 m", "particles fit into"},
    {"AxisWithoutLength", "axis = [0.0, 0.0, 2.0]", "axis = [0.0, 0.0, 0.0]", "axis = [0, 0, 0]", "above 0"},
    {"RadiusOfZero", "radius = 0.8", "radius = 0.0", "radius = 0", "above 0"},
    {"NoSide", ", side = \"inside\"", "", "no \"side\"", "\"side\"", "cylinder ="},
    {"UnknownSide", "\"inside\"", "\"within\"", "side = \"within\"", "\"inside\" or \"outside\""},
    {"UnknownKeyOfCylinder", "radius = 0.8", "diameter = 1.6", "unknown key \"diameter\"", "\"radius\""},
    {"DeepInACylinder", "radius = 0.8", "radius = 0.5", "in wall floor by 119.8 % of its radius",
     "half the radius", "[0.1, 0.5, 0.0]"},
    {"CylinderAcrossAPeriod", "axis = [0.0, 0.0, 2.0]", "axis = [0.0, 0.1, 2.0]", "cut by a periodic face",
     "the same all along", "[[wall]]"},
    {"CylinderBeyondAPeriod", "cylinder = { point = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 2.0]",
     "cylinder = { point = [0.0, 0.0, 0.3], axis = [0.0, 1.0, 0.0]", "cut by a periodic face",
     "stay within it", "[[wall]]"},
    {"RectangleNearAPeriod", turning_shape,
     "rectangle = { lower = [-1.0, 0.9, -1.0], upper = [1.0, 0.9, 0.96] }", "cut by a periodic face",
     "stay within it", "[[wall]]"},
};

const Mistake motions[] = {
    {"RectangleThatTurns", shape, "rectangle = { lower = [-1.0, 0.9, -1.0], upper = [1.0, 0.9, 1.0] }",
     "a rectangle that turns", "turn within themselves", motion},
    {"PlaneThatTurnsInAPeriod", shape, "plane = { point = [0.0, -0.9, 0.0], normal = [0.0, 1.0, 0.0] }",
     "turning in a periodic domain", "along the periodic axis", "[[wall]]"},
    {"MotionOfUnknownShape", motion, "motion = { speed = 1.0 }", "unknown key \"speed\"", "\"rate\""},
    {"MotionOfNothing", motion, "motion = { phase = 1.0 }", "no known kind", "velocity, rate and amplitude"},
    {"TwoMotions", motion, "motion = { rate = 1.0, velocity = [1.0, 0.0, 0.0] }", "no known kind", "one of"},
    {"VibrationWithoutFrequency", motion, "motion = { amplitude = [0.1, 0.0, 0.0] }", "no \"frequency\"",
     "\"frequency\""},
    {"FrequencyOfZero", motion, "motion = { amplitude = [0.1, 0.0, 0.0], frequency = 0.0 }", "frequency = 0",
     "above 0"},
    {"PhaseOfTurning", motion, "motion = { rate = 1.0, phase = 1.0 }", "unknown key \"phase\"", "\"rate\""},
    {"MotionInWords", motion, "motion = \"turning\"", "motion = \"turning\"", "a table"},
    {"MotionWithoutNumber", motion, "motion = { rate = nan }", "nan", "a finite number"},
    {"RectangleThatMovesAlongAPeriod",
     "[0.0, 0.0, 0.0], axis = [0.0, 0.0, 2.0], radius = 0.8, side = \"inside\" }\nmotion = { rate = 1.0 }",
     "[0.0, 0.0, 0.0], axis = [1.0, 0.0, 0.0], radius = 0.8, side = \"inside\" }\n"
     "motion = { velocity = [0.0, 0.0, 0.1] }",
     "moving along a periodic axis", "across it", "[[wall]]"},
};

INSTANTIATE_TEST_SUITE_P(Shapes, WallRefusal, ::testing::ValuesIn(shapes), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Motions, WallRefusal, ::testing::ValuesIn(motions), name_of_mistake);

TEST(Walls, ACylinderWithinAPeriodMayStandAcrossIt) {
  const std::string across = with(in_a_drum(), "axis = [0.0, 0.0, 2.0]", "axis = [1.0, 0.0, 0.0]");
  EXPECT_EQ(refusal_of(across), "");
  // Its solid would then stand at the faces, but particles meet it only within 0.8 + 0.05 of its axis.
  const std::string outside = with(with(across, "\"inside\"", "\"outside\""), "radius = 0.8", "radius = 0.3");
  const std::string apart = with(outside, "point = [0.0, 0.0, 0.0]", "point = [0.0, -0.6, 0.64]");
  EXPECT_EQ(refusal_of(apart), "");
  EXPECT_NE(refusal_of(with(apart, "0.64]", "0.66]")).find("cut by a periodic face"), std::string::npos);
}

}  // namespace
}  // namespace grainproof
