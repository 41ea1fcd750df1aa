// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

/// The example with spheres that turn and meet by Hertz' law, with friction that remembers.
std::string turning_example() {
  std::string text = with(example, "[material.glass]\ndensity = 2000.0",
                          "[bodies]\nrotation = true\n\n[material.glass]\ndensity = 2000.0\n"
                          "youngs_modulus = 48e9\npoisson_ratio = 0.2");
  text = with(text, "law = \"linear\", stiffness = 1e5, restitution = 0.8 }",
              "law = \"hertz\", restitution = 0.8 }\nfriction = { law = \"history\", coefficient = 0.3 }");
  text = with(text, "restitution = 0.9 }",
              "restitution = 0.9 }\nfriction = { law = \"history\", coefficient = 0.3, stiffness = 3e4 }\n"
              "rolling = { law = \"spring\", coefficient = 0.1 }");
  return with(text, "velocities = [[-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]",
              "velocities = [[-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]\n"
              "angular_velocities = [[0.0, 0.0, 5.0], [0.0, 0.0, 0.0]]");
}

const std::string turning = turning_example();

class ContactRefusal : public Refusal {};

TEST_P(ContactRefusal, NamesThePlaceWhatWasFoundAndWhatWasExpected) {
  expect_refused(GetParam(), turning);
}

constexpr const char* spins = "angular_velocities = [[0.0, 0.0, 5.0], [0.0, 0.0, 0.0]]";
constexpr const char* hertz = "normal = { law = \"hertz\", restitution = 0.8 }";
constexpr const char* mindlin = "friction = { law = \"history\", coefficient = 0.3 }";

const Mistake rotation[] = {
    {"FewerSpinsThanPositions", spins, "angular_velocities = [[0.0, 0.0, 5.0]]", "angular_velocities of 1",
     "each of the 2"},
    {"SpinOfTwoNumbers", spins, "angular_velocities = [[0.0, 5.0], [0.0, 0.0, 0.0]]", "an array of 2",
     "three numbers"},
    {"SpinThatIsNoNumber", spins, "angular_velocities = [[0.0, nan, 5.0], [0.0, 0.0, 0.0]]", "nan",
     "a finite number"},
    {"FixedButSpinning", "fixed = true", "fixed = true\nangular_velocities = [[1.0, 0.0, 0.0]]",
     "an array of 3", "fixed particles never move", "angular_velocities = [[1"},
    {"UnknownKeyOfBodies", "rotation = true", "rotating = true", "unknown key \"rotating\"", "\"rotation\""},
};

const Mistake elasticity[] = {
    {"ModulusAlone", "poisson_ratio = 0.2\n", "", "youngs_modulus alone", "poisson_ratio beside it",
     "youngs_modulus"},
    {"PoissonAlone", "youngs_modulus = 48e9\n", "", "poisson_ratio alone", "youngs_modulus beside it",
     "poisson_ratio"},
    {"ModulusOfZero", "youngs_modulus = 48e9", "youngs_modulus = 0.0", "youngs_modulus = 0", "above 0"},
    {"PoissonOfMinusOne", "poisson_ratio = 0.2", "poisson_ratio = -1.0", "poisson_ratio = -1",
     "above -1 and up to 0.5"},
    {"PoissonAboveHalf", "poisson_ratio = 0.2", "poisson_ratio = 0.51", "poisson_ratio = 0.51",
     "above -1 and up to 0.5"},
    {"PoissonThatIsNoNumber", "poisson_ratio = 0.2", "poisson_ratio = nan", "nan", "a finite number"},
    {"HertzWithoutElasticity", "normal = { law = \"linear\", stiffness = 1e6, restitution = 0.9 }",
     "normal = { law = \"hertz\", restitution = 0.9 }", "material steel, whose elasticity is not given",
     "youngs_modulus and poisson_ratio of steel"},
};

const Mistake laws[] = {
    {"StiffnessOfHertz", hertz, "normal = { law = \"hertz\", stiffness = 1e5, restitution = 0.8 }",
     "unknown key \"stiffness\"", "\"restitution\""},
    {"DashpotOfHertz", hertz, "normal = { law = \"hertz\", damping = 1.0 }", "unknown key \"damping\"",
     "\"restitution\""},
    {"HertzWithoutRestitution", hertz, "normal = { law = \"hertz\" }", "no \"restitution\"",
     "\"restitution\""},
    {"HertzThatNeverRebounds", hertz, "normal = { law = \"hertz\", restitution = 0.0 }", "restitution = 0",
     "more than 0"},
    {"HertzThatGainsEnergy", hertz, "normal = { law = \"hertz\", restitution = 1.1 }", "restitution = 1.1",
     "from 0 to 1"},
    {"StiffnessOfMindlin", mindlin, "friction = { law = \"history\", coefficient = 0.3, stiffness = 1.0 }",
     "stiffness = 1", "no stiffness"},
    {"CollisionTimeOfHertz", mindlin,
     "friction = { law = \"collision_time\", coefficient = 0.3, stiffness = 1.0 }",
     "law = \"collision_time\"", "\"none\", \"step\" or \"history\""},
    {"DashpotOfHertzTwice", hertz, "normal = { law = \"hertz\", restitution = 0.8, damping_ratio = 0.1 }",
     "damping_ratio = 0.1", "either restitution or damping_ratio"},
    {"NegativeDampingRatioOfHertz", hertz, "normal = { law = \"hertz\", damping_ratio = -0.1 }",
     "damping_ratio = -0.1", "positive"},
    {"UnknownMemory", "stiffness = 3e4", "stiffness = 3e4, memory = \"stiffness\"", "memory = \"stiffness\"",
     "\"displacement\" or \"force\""},
    {"HistoryWithoutStiffness", ", stiffness = 3e4", "", "no \"stiffness\"", "\"stiffness\"",
     "coefficient = 0.3 }\nrolling"},
    {"HistoryWithoutStiffnessAbove0", "stiffness = 3e4", "stiffness = 0.0", "stiffness = 0", "above 0"},
    {"NegativeDampingRatio", "stiffness = 3e4", "stiffness = 3e4, damping_ratio = -0.5",
     "damping_ratio = -0.5", "positive"},
    {"NegativeCoefficient", mindlin, "friction = { law = \"history\", coefficient = -0.3 }",
     "coefficient = -0.3", "positive"},
    {"UnknownLimit", "stiffness = 3e4", "stiffness = 3e4, limit = \"dashpot\"", "limit = \"dashpot\"",
     "\"spring\" or \"spring_and_dashpot\""},
    {"UnknownArm", "stiffness = 3e4", "stiffness = 3e4, arm = \"diameter\"", "arm = \"diameter\"",
     "\"radius\" or \"overlap\""},
    {"UnknownTurn", "stiffness = 3e4", "stiffness = 3e4, turn = \"rescale\"", "turn = \"rescale\"",
     "\"project\" or \"project_and_rescale\""},
    {"UnknownKeyOfHistory", "stiffness = 3e4", "stiffness = 3e4, turns = \"project\"",
     "unknown key \"turns\"", "\"turn\""},
};

constexpr const char* rolling = "rolling = { law = \"spring\", coefficient = 0.1 }";

const Mistake resistance[] = {
    {"SpringAgainstRollingWithoutOneOfFriction",
     "friction = { law = \"history\", coefficient = 0.3, stiffness = 3e4 }",
     "friction = { law = \"none\", coefficient = 0.3 }", "without friction that has one", "\"history\"",
     rolling},
    {"UnknownRolling", rolling, "rolling = { law = \"springs\", coefficient = 0.1 }", "\"springs\"",
     "\"spring\""},
    {"NegativeRolling", rolling, "rolling = { law = \"constant_torque\", coefficient = -0.1 }",
     "coefficient = -0.1", "positive"},
    {"StiffnessOfRolling", rolling, "rolling = { law = \"spring\", coefficient = 0.1, stiffness = 3.0 }",
     "unknown key \"stiffness\"", "\"law\" or \"coefficient\""},
    {"UnknownOrientation", "rotation = true", "rotation = true\norientation = \"euler\"",
     "orientation = \"euler\"", "\"forward_euler\"", "orientation ="},
};

const Mistake speeds[] = {
    {"NothingMovesTowardsAHertzContact", "[[-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]",
     "[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]", "no impact_speed, where nothing moves yet", "impact_speed",
     "[run]"},
    {"ImpactSpeedOfZero", "end = 0.01", "end = 0.01\nimpact_speed = 0.0", "impact_speed = 0", "above 0",
     "impact_speed"},
    {"StepAboveTheLimitOfTheSpring", "step = \"contact/64\"", "step = 1e-4", "a step of 1e-04 s",
     "bodies of glass and glass with up to 3 contacts at once"},
};

INSTANTIATE_TEST_SUITE_P(Rotation, ContactRefusal, ::testing::ValuesIn(rotation), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Elasticity, ContactRefusal, ::testing::ValuesIn(elasticity), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Laws, ContactRefusal, ::testing::ValuesIn(laws), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Resistance, ContactRefusal, ::testing::ValuesIn(resistance), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Speeds, ContactRefusal, ::testing::ValuesIn(speeds), name_of_mistake);

TEST(Refusals, TheColumnOfAPoissonRatioIsThatOfItsValue) {
  const std::string text = with(turning, "poisson_ratio = 0.2", "poisson_ratio = 0.6");
  const std::string place = "scene.toml:" + std::to_string(line_of(text, "poisson_ratio")) + ":17: ";
  const std::string message = refusal_of(text);
  EXPECT_TRUE(message.starts_with(place + "found poisson_ratio = 0.6")) << message;
}

TEST(Refusals, RollingSpinsAndOrientationNeedAWorldInWhichBodiesTurn) {
  std::string still = with(turning, "rotation = true", "rotation = false");
  EXPECT_NE(refusal_of(still).find("rolling in a scene without rotation"), std::string::npos);
  still = with(still, std::string(rolling) + "\n", "");
  EXPECT_NE(refusal_of(still).find("angular_velocities in a scene without rotation"), std::string::npos);
  still = with(still, std::string(spins) + "\n", "");
  EXPECT_EQ(refusal_of(still), "");
  still = with(still, "rotation = false", "rotation = false\norientation = \"exponential\"");
  EXPECT_NE(refusal_of(still).find("orientation in a scene without rotation"), std::string::npos);
}

TEST(Refusals, TheTurningSceneItselfIsRead) {
  const Scene scene = read_text(turning).scenes.at(0).scene;
  EXPECT_TRUE(scene.rotation);
  EXPECT_EQ(scene.particles[1].angular_velocity, Vec3(0.0, 0.0, 5.0));
  EXPECT_FALSE(scene.materials[1].elasticity);
  EXPECT_EQ(scene.materials[0].elasticity->youngs_modulus, 48e9);
  EXPECT_EQ(std::get<SpringRolling>(scene.contacts.at(0, 1).rolling).coefficient, 0.1);
  EXPECT_TRUE(std::holds_alternative<NoRolling>(scene.contacts.at(0, 0).rolling));
}

}  // namespace
}  // namespace grainproof
