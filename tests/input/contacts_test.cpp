// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/input/example.hpp"

namespace grainproof {
namespace {

/// A glass sphere meets a glass sphere or the steel floor, by Hertz' law both.
std::string hertzian(const std::string& friction = "", const std::string& more = "") {
  std::string text =
      with(example, "density = 2000.0", "density = 2000.0\nyoungs_modulus = 48e9\npoisson_ratio = 0.2");
  text = with(text, "density = 7800.0", "density = 7800.0\nyoungs_modulus = 208e9\npoisson_ratio = 0.3");
  text = with(text, "law = \"linear\", stiffness = 1e5, restitution = 0.8 }",
              "law = \"hertz\", restitution = 0.8 }" + (friction.empty() ? "" : "\nfriction = " + friction));
  return with(text, "law = \"linear\", stiffness = 1e6,", "law = \"hertz\",") + more;
}

TEST(HertzContact, KeepsItsRestitution) {
  const Scene scene = read_text(hertzian()).scenes.at(0).scene;
  const auto& law = std::get<HertzNormal>(scene.contacts.at(0, 0).normal);
  EXPECT_EQ(std::get<Restitution>(law.dissipation).value, 0.8);
}

/// 2.943275 δ_max/v by hand, for the pair and the floor: the floor is the harder.
TEST(HertzContact, StepIsAFractionOfTheShortestAtTheClosingSpeed) {
  const double mass = 2000.0 * M_PI / 6.0 * 1e-3, speed = 2.0;
  const double modulus = 1.0 / ((1 - 0.04) / 48e9 + (1 - 0.09) / 208e9), radius = 0.05;
  const double peak = std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
  const double step = read_text(hertzian()).scenes.at(0).scene.run.step;
  EXPECT_NEAR(step * 64 / (2.943275 * peak / speed), 1.0, 1e-6);  // the constant has seven digits
}

TEST(HertzContact, ImpactSpeedStandsInForTheSceneSOwn) {
  const auto step_at = [](const std::string& speed) {
    return read_text(with(hertzian(), "end = 0.01", "end = 0.01\nimpact_speed = " + speed))
        .scenes.at(0)
        .scene.run.step;
  };
  EXPECT_EQ(step_at("2.0"), read_text(hertzian()).scenes.at(0).scene.run.step);
  EXPECT_NEAR(step_at("64.0") / step_at("2.0"), 0.5, 1e-14);  // as v^(-1/5)
}

TEST(HistoryFriction, HasTheModelsVariantByDefaultAndNoDashpot) {
  const Scene scene = read_text(hertzian("{ law = \"history\", coefficient = 0.3 }")).scenes.at(0).scene;
  const auto& law = std::get<HistoryFriction>(scene.contacts.at(0, 0).friction);
  EXPECT_EQ(law.coefficient, 0.3);
  EXPECT_EQ(law.damping_ratio, 0.0);
  EXPECT_EQ(law.limit, CoulombLimit::spring_and_dashpot);
  EXPECT_EQ(law.arm, TorqueArm::radius);
  EXPECT_EQ(law.turn, SpringTurn::project);
}

TEST(HistoryFriction, IsReadKeyByKey) {
  const std::string text =
      example_with("stiffness = 1e5, restitution = 0.8 }",
                   "stiffness = 1e5, restitution = 0.8 }\nfriction = { law = \"history\", coefficient = 0.4, "
                   "stiffness = 3e4, "
                   "damping_ratio = 0.5, limit = \"spring\", arm = \"overlap\", turn = \"project\" }");
  const Scene scene = read_text(text).scenes.at(0).scene;
  const auto& law = std::get<HistoryFriction>(scene.contacts.at(0, 0).friction);
  EXPECT_EQ(law.stiffness, 3e4);
  EXPECT_EQ(law.damping_ratio, 0.5);
  EXPECT_EQ(law.limit, CoulombLimit::spring);
  EXPECT_EQ(law.arm, TorqueArm::overlap);
  EXPECT_EQ(law.turn, SpringTurn::project);
}

TEST(Rotation, IsOffUnlessAskedFor) {
  EXPECT_FALSE(read_text(example).scenes.at(0).scene.rotation);
}

TEST(Rotation, OrientationTurnsSpinsWithVelocities) {
  std::string text = with(example, "[field]", "[bodies]\nrotation = true\n[field]");
  text = with(text, "[0.0, 0.0, 0.0]]\n\n[bodies]",
              "[0.0, 0.0, 0.0]]\nangular_velocities = [[-6.0, 0.0, 0.0], [0.0, 4.0, 0.0]]\n\n[bodies]");
  const Case read = read_text(text + "\n[sweep]\norientation = 5\n");
  ASSERT_EQ(read.scenes.size(), 5u);
  for (const ResolvedScene& resolved : read.scenes) {
    const auto& particles = resolved.scene.particles;
    EXPECT_LT((particles[1].angular_velocity - 3.0 * particles[1].velocity).norm(), 1e-14);
    EXPECT_NEAR(particles[2].angular_velocity.norm(), 4.0, 1e-14);
    EXPECT_NEAR(particles[2].angular_velocity.dot(particles[1].velocity), 0.0, 1e-14);
  }
}

TEST(Sweeps, OfMaterialNumbersChangeTheMaterialAndTheStep) {
  const Case read = read_text(hertzian("",
                                       "\n[sweep]\n\"material.steel.youngs_modulus\" = [208e9, 104e9]\n"
                                       "\"material.glass.poisson_ratio\" = [0.2, 0.3]\n"));
  ASSERT_EQ(read.scenes.size(), 4u);
  EXPECT_EQ(read.scenes[3].scene.materials[1].elasticity->youngs_modulus, 104e9);
  EXPECT_EQ(read.scenes[3].scene.materials[0].elasticity->poisson_ratio, 0.3);
  EXPECT_GT(read.scenes[1].scene.run.step, read.scenes[0].scene.run.step);
}

}  // namespace
}  // namespace grainproof
