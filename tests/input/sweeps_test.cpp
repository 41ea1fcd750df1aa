// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "model/errors.hpp"
#include "tests/input/example.hpp"

namespace grainproof {
namespace {

Case swept(const std::string& sweep) {
  return read_text(example + "\n[sweep]\n" + sweep + "\n");
}

/// π/ω_d of the stiffest contact, the glass sphere on the steel floor: m = 2000 π/6 · 10⁻³ kg,
/// k = 1e6 N/m, ε = 0.9, where ω_d = sqrt(k/m) π/sqrt(π² + ln² ε).
double shortest_contact_of_example() {
  const double mass = 2000.0 * std::numbers::pi / 6.0 * 1e-3;
  return std::sqrt(mass / 1e6) * std::hypot(std::numbers::pi, std::log(0.9));
}

TEST(Sweeps, WithoutOneThereIsOneScene) {
  const Case read = read_text(example);
  ASSERT_EQ(read.scenes.size(), 1u);
  EXPECT_EQ(read.name, "scene");
  EXPECT_EQ(read.title, "Example");
  EXPECT_EQ(read.scenes[0].point.step, "contact/64");
  EXPECT_EQ(read.scenes[0].point.steps_per_contact, 64.0);
  EXPECT_NEAR(read.scenes[0].scene.run.step, shortest_contact_of_example() / 64.0, 1e-15);
}

TEST(Sweeps, SeveralKeysAreTheFullProduct) {
  const Case read = swept(
      "step = [\"contact/32\", 1e-5]\nintegrator = [\"velocity_verlet\", \"leapfrog_verlet\"]\n"
      "offset = [[0, 0, 0], [1.0, 0, 0], [2, 0, 0]]\n\"contact.0.normal.restitution\" = [1.0, "
      "0.8]\norientation = 5");
  std::set<std::tuple<std::string, std::map<std::string, std::string>, int>> points;
  for (const ResolvedScene& scene : read.scenes)
    points.insert({scene.point.step, scene.point.values, scene.point.sample});
  EXPECT_EQ(read.scenes.size(), 2u * 2u * 3u * 2u * 5u);
  EXPECT_EQ(points.size(), read.scenes.size());
}

TEST(Sweeps, PointsSayWhatTheirScenesAre) {
  const Case read = swept("\"contact.0.normal.restitution\" = [1, 0.8]\nintegrator = [\"leapfrog_verlet\"]");
  ASSERT_EQ(read.scenes.size(), 2u);
  for (const ResolvedScene& resolved : read.scenes) {
    const auto& law = std::get<LinearNormal>(resolved.scene.contacts.at(0, 0).normal);
    const std::string label = std::get<Restitution>(law.dissipation).value == 1.0 ? "1" : "0.8";
    EXPECT_EQ(resolved.point.values.at("contact.0.normal.restitution"), label);
    EXPECT_EQ(resolved.scene.run.integrator, Integrator::leapfrog_verlet);
    EXPECT_EQ(resolved.point.values.at("integrator"), "leapfrog_verlet");
  }
}

TEST(Sweeps, AStepInSecondsKeepsItsShortestLabel) {
  const Case read = swept("step = [1e-5, 0.00002]");
  EXPECT_EQ(read.scenes[0].point.step, "1e-05");
  EXPECT_EQ(read.scenes[1].point.step, "2e-05");
  EXPECT_EQ(read.scenes[1].scene.run.step, 2e-5);
  EXPECT_EQ(read.scenes[1].point.steps_per_contact, 0.0);
}

TEST(Sweeps, OnsetTakesMovingParticlesBackByAFractionOfAStep) {
  const Case read = swept("onset = { phases = 4, at = \"body\" }");
  ASSERT_EQ(read.scenes.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    const Scene& scene = read.scenes[i].scene;
    EXPECT_EQ(read.scenes[i].point.sample, i);
    EXPECT_EQ(scene.particles[0].position, Vec3::Zero());
    EXPECT_NEAR(scene.particles[1].position[0], 0.1 + 2.0 * scene.run.step * (i + 0.5) / 4.0, 1e-16);
    EXPECT_EQ(scene.particles[2].position, Vec3(0.1, 0.5, 0.0));
  }
}

TEST(Sweeps, DitherSpreadsStepsPerContactEvenlyOverOne) {
  constexpr int phases = 256;
  const Case read = swept("step_dither = true\nonset = { phases = 256, at = \"body\" }");
  std::vector<double> u;
  for (const ResolvedScene& resolved : read.scenes)
    u.push_back(shortest_contact_of_example() / resolved.scene.run.step - 64.0);
  std::sort(u.begin(), u.end());
  ASSERT_EQ(u.size(), std::size_t{phases});
  EXPECT_GE(u.front(), -0.5);
  EXPECT_LE(u.back(), 0.5);
  // The largest gap of n points of a golden-ratio recurrence is below 2/n (three-distance theorem).
  for (int i = 1; i < phases; ++i) EXPECT_LT(u[i] - u[i - 1], 2.0 / phases);
}

TEST(Sweeps, DitherAndOnsetDoNotMoveTogether) {
  const Case read = swept("step_dither = true\nonset = { phases = 256, at = \"body\" }");
  double covariance = 0.0;
  for (const ResolvedScene& resolved : read.scenes) {
    const double u = shortest_contact_of_example() / resolved.scene.run.step - 64.0;
    covariance += u * ((resolved.point.sample + 0.5) / 256.0 - 0.5) / 256.0;
  }
  EXPECT_LT(std::abs(covariance) * 12.0, 0.05);  // the variance of either is 1/12
}

TEST(Sweeps, DitherSharesTheIndexOfTheOrientationWhereThereIsNoOnset) {
  const Case read = swept("step_dither = true\norientation = 7");
  std::set<double> steps;
  for (const ResolvedScene& resolved : read.scenes) steps.insert(resolved.scene.run.step);
  EXPECT_EQ(read.scenes.size(), 7u);
  EXPECT_EQ(steps.size(), 7u);
}

TEST(Sweeps, OffsetMovesParticlesWallsAndDomain) {
  const Case read = swept("offset = [[0.0, 0.0, 0.0], [1.0, 2.0, 3.0]]");
  const Vec3 offset(1.0, 2.0, 3.0);
  const Scene& here = read.scenes[0].scene;
  const Scene& there = read.scenes[1].scene;
  EXPECT_EQ(there.domain.lower, here.domain.lower + offset);
  EXPECT_EQ(there.domain.upper, here.domain.upper + offset);
  EXPECT_EQ(there.particles[2].position, here.particles[2].position + offset);
  EXPECT_EQ(std::get<Plane>(there.walls[0].shape).point, std::get<Plane>(here.walls[0].shape).point + offset);
  EXPECT_EQ(read.scenes[1].point.values.at("offset"), "[1, 2, 3]");
}

TEST(Sweeps, AnOffsetInDiametersIsInTheLargestOfThemAsScaled) {
  const Case read = swept("scale = [10]\noffset = [{ diameters = [1e6, 0, 2] }]");
  EXPECT_NEAR(read.scenes[0].scene.particles[0].position[0], 1e6, 1e-9);
  EXPECT_NEAR(read.scenes[0].scene.particles[0].position[2], 2.0, 1e-15);
  EXPECT_EQ(read.scenes[0].point.values.at("offset"), "{ diameters = [1e+06, 0, 2] }");
}

// Lengths and times in units of their own: diameter, contact's duration, speed of approach.
TEST(Sweeps, AScaleChangesNoDimensionlessNumber) {
  const Case read = swept("scale = [1.0, 1e-5]");
  const Scene &here = read.scenes[0].scene, &there = read.scenes[1].scene;
  const auto gravity = [](const Scene& scene) {
    return std::get<ConstantGravity>(scene.gravity).acceleration[2] * scene.run.step / 2.0;
  };
  const auto stiffness = [](const Scene& scene) {
    const double mass = 2000.0 * std::pow(scene.particles[0].diameter, 3);
    return std::get<LinearNormal>(scene.contacts.at(0, 0).normal).stiffness * std::pow(scene.run.step, 2) /
           mass;
  };
  EXPECT_NEAR(there.particles[0].diameter, 1e-6, 1e-20);
  EXPECT_NEAR(there.run.step / here.run.step, 1e-5, 1e-19);
  EXPECT_NEAR(there.run.end / there.run.step, here.run.end / here.run.step, 1e-9);
  EXPECT_NEAR(there.run.sample_times[1] / there.run.step, here.run.sample_times[1] / here.run.step, 1e-9);
  EXPECT_EQ(there.particles[1].velocity, here.particles[1].velocity);
  EXPECT_NEAR(gravity(there) / gravity(here), 1.0, 1e-14);
  EXPECT_NEAR(stiffness(there) / stiffness(here), 1.0, 1e-14);
  EXPECT_NEAR(std::get<Plane>(there.walls[0].shape).point[2], -0.5e-5, 1e-20);
  EXPECT_EQ(read.scenes[1].point.values.at("scale"), "1e-05");
}

TEST(Sweeps, AStepInSecondsIsScaledUnderTheLabelThatItHas) {
  const Case read = swept("scale = [10]\nstep = [1e-5]");
  EXPECT_NEAR(read.scenes[0].scene.run.step, 1e-4, 1e-19);
  EXPECT_EQ(read.scenes[0].point.step, "1e-05");
}

TEST(Sweeps, OrientationKeepsEveryAngleAndDistance) {
  const Scene plain = read_text(example).scenes[0].scene;
  const Case read = swept("orientation = { samples = 20, seed = 3 }");
  const auto normal = [](const Scene& scene) { return std::get<Plane>(scene.walls[0].shape).normal; };
  const auto gravity = [](const Scene& scene) {
    return std::get<ConstantGravity>(scene.gravity).acceleration;
  };
  for (const ResolvedScene& resolved : read.scenes) {
    const Scene& turned = resolved.scene;
    EXPECT_NEAR((turned.particles[2].position - turned.particles[1].position).norm(), 0.5, 1e-15);
    EXPECT_NEAR(normal(turned).dot(gravity(turned)), normal(plain).dot(gravity(plain)), 1e-14);
    EXPECT_NEAR(turned.particles[1].velocity.dot(turned.particles[1].position),
                plain.particles[1].velocity.dot(plain.particles[1].position), 1e-15);
    EXPECT_NEAR(normal(turned).dot(turned.particles[1].velocity.cross(turned.particles[2].position)),
                normal(plain).dot(plain.particles[1].velocity.cross(plain.particles[2].position)), 1e-15);
  }
}

TEST(Sweeps, OrientationsPointEverywhere) {
  const Case read = swept("orientation = { samples = 1000, seed = 3 }");
  Vec3 mean = Vec3::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const ResolvedScene& resolved : read.scenes) {
    const Vec3 normal = std::get<Plane>(resolved.scene.walls[0].shape).normal;
    mean += normal / 1000.0;
    squares += normal * normal.transpose() / 1000.0;
  }
  // Four standard deviations of a mean over 1000: of a component 1/sqrt(3), of its square sqrt(4/45).
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 4.0 * std::sqrt(1.0 / 3.0 / 1000.0));
  EXPECT_LT((squares - Eigen::Matrix3d::Identity() / 3.0).cwiseAbs().maxCoeff(),
            4.0 * std::sqrt(4.0 / 45.0 / 1000.0));
}

TEST(Sweeps, AnIntegratorThatIsStableWhereAnotherIsNotIsJudgedByItself) {
  const std::string verlet = "integrator = [\"velocity_verlet\"]\nstep = [\"contact/8\"]";
  EXPECT_NO_THROW(swept(verlet));
  EXPECT_THROW(swept(with(verlet, "velocity_verlet", "euler_trapezoid")), InputRefused);
}

}  // namespace
}  // namespace grainproof
