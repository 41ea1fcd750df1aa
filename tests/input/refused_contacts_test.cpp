// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

/// Two turning spheres that meet by Hertz' law, with friction that remembers.
const std::string turning = R"(schema = 1

[run]
end = 0.01
step = "contact/64"

[domain]
lower = [-1.0, -1.0, -1.0]
upper = [1.0, 1.0, 1.0]

[bodies]
rotation = true

[material.glass]
density = 2000.0
youngs_modulus = 48e9
poisson_ratio = 0.2

[material.cork]
density = 200.0

[[contact]]
between = ["glass", "glass"]
normal = { law = "hertz", restitution = 0.8 }
friction = { law = "history", coefficient = 0.3 }

[[contact]]
between = ["glass", "cork"]
normal = { law = "linear", stiffness = 1e5, restitution = 0.8 }
friction = { law = "history", coefficient = 0.3, stiffness = 3e4 }

[[particles]]
material = "glass"
diameter = 0.1
fixed = true
positions = [[0.0, 0.0, 0.0]]

[[particles]]
material = "glass"
diameter = 0.1
positions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]
velocities = [[-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
angular_velocities = [[0.0, 0.0, 5.0], [0.0, 0.0, 0.0]]
)";

class ContactRefusal : public Refusal {};

TEST_P(ContactRefusal, NamesThePlaceWhatWasFoundAndWhatWasExpected) {
  expect_refused(GetParam(), turning);
}

constexpr const char* spins = "angular_velocities = [[0.0, 0.0, 5.0], [0.0, 0.0, 0.0]]";
constexpr const char* hertz = "normal = { law = \"hertz\", restitution = 0.8 }";
constexpr const char* mindlin = "friction = { law = \"history\", coefficient = 0.3 }";

const Mistake rotation[] = {
    {"SpinWithoutRotation", "rotation = true", "rotation = false",
     "angular_velocities in a scene without rotation", "rotation = true", spins},
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
    {"HertzWithoutElasticity", "normal = { law = \"linear\", stiffness = 1e5, restitution = 0.8 }",
     "normal = { law = \"hertz\",  restitution = 0.8 }", "material cork, whose elasticity is not given",
     "youngs_modulus and poisson_ratio of cork"},
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
    {"HistoryWithoutStiffness", ", stiffness = 3e4", "", "no \"stiffness\"", "\"stiffness\"",
     "coefficient = 0.3 }\n\n[[particles]]"},
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

const Mistake speeds[] = {
    {"NothingMovesTowardsAHertzContact", "[[-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]",
     "[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]", "no impact_speed, where nothing moves yet", "impact_speed",
     "[run]"},
    {"ImpactSpeedOfZero", "end = 0.01", "end = 0.01\nimpact_speed = 0.0", "impact_speed = 0", "above 0",
     "impact_speed"},
    {"StepAboveTheLimitOfTheSpring", "step = \"contact/64\"", "step = 1e-4", "a step of 1e-04 s",
     "friction of glass and glass"},
};

INSTANTIATE_TEST_SUITE_P(Rotation, ContactRefusal, ::testing::ValuesIn(rotation), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Elasticity, ContactRefusal, ::testing::ValuesIn(elasticity), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Laws, ContactRefusal, ::testing::ValuesIn(laws), name_of_mistake);
INSTANTIATE_TEST_SUITE_P(Speeds, ContactRefusal, ::testing::ValuesIn(speeds), name_of_mistake);

TEST(Refusals, TheColumnOfAPoissonRatioIsThatOfItsValue) {
  const std::string message = refusal_of(with(turning, "poisson_ratio = 0.2", "poisson_ratio = 0.6"));
  EXPECT_TRUE(message.starts_with("scene.toml:17:17: found poisson_ratio = 0.6")) << message;
}

TEST(Refusals, TheTurningSceneItselfIsRead) {
  const Scene scene = read_text(turning).scenes.at(0).scene;
  EXPECT_TRUE(scene.rotation);
  EXPECT_EQ(scene.particles[1].angular_velocity, Vec3(0.0, 0.0, 5.0));
  EXPECT_FALSE(scene.materials[0].elasticity);
  EXPECT_EQ(scene.materials[1].elasticity->youngs_modulus, 48e9);
}

}  // namespace
}  // namespace grainproof
