// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "device_fixture.hpp"
#include "scenes.hpp"
#include "varied_scenes.hpp"

/// velocity_verlet_implicit and pefrl: what is evaluated several times a step.
namespace grainproof::opencl::testing {
namespace {

class Schemes : public ::testing::TestWithParam<Precision> {};

std::uint64_t digest_of(Precision precision, const Scene& scene, Path path, Stages stages,
                        std::optional<double> skin) {
  EngineOptions options = options_for(precision);
  options.path = path;
  options.stages = stages;
  options.skin = skin;
  OpenClEngine engine(options);
  const auto run = engine.start(scene, {});
  run->advance(120);
  return run->digest();
}

TEST_P(Schemes, ImplicitDashpotsGiveTheSameBitsOnBothPathsHoweverShortListsLast) {
  Scene scene = varied_scene("hertz_and_springs", 2);
  scene.run.integrator = Integrator::velocity_verlet_implicit;
  const std::uint64_t small = digest_of(GetParam(), scene, Path::small, Stages::lean, {});
  // Whether a stage left idle changes a bit is no matter of precision.
  if (GetParam() == Precision::double_precision) {
    EXPECT_EQ(digest_of(GetParam(), scene, Path::small, Stages::full, {}), small);
  }
  for (const double skin : {0.0, 0.01})
    EXPECT_EQ(digest_of(GetParam(), scene, Path::zoned, Stages::lean, skin), small) << skin;
}

TEST(SchemesInDouble, PefrlGivesTheSameBitsWithEveryStageCompiled) {
  Scene scene = varied_scene("hertz_and_springs", 2);
  scene.run.integrator = Integrator::pefrl;
  EXPECT_EQ(digest_of(Precision::double_precision, scene, Path::small, Stages::full, {}),
            digest_of(Precision::double_precision, scene, Path::small, Stages::lean, {}));
}

/// On its way round a centre, against a run of 64 times the steps.
double orbit_error(Precision precision, Integrator integrator, int steps) {
  const auto end = [&](int count) {
    Scene scene = empty_scene(0.8);
    scene.gravity = CentralGravity{1.0, Vec3::Zero()};
    scene.particles = {sphere(0, {0.7, 0.0, 0.0}, {0.0, 0.7, 0.1})};
    scene.run.integrator = integrator;
    scene.run.step = 1.0 / count;
    scene.run.end = 1.0;
    scene.run.sample_times = {0.0, 1.0};
    return observed(options_for(precision), scene).frames.back().position[0];
  };
  return (end(steps) - end(64 * steps)).norm();
}

TEST(SchemesInDouble, AreOfTheirOrderInASmoothField) {
  const auto order = [](Integrator integrator, int steps) {
    return std::log2(orbit_error(Precision::double_precision, integrator, steps) /
                     orbit_error(Precision::double_precision, integrator, 2 * steps));
  };
  EXPECT_NEAR(order(Integrator::pefrl, 8), 4.0, 0.1);
  EXPECT_NEAR(order(Integrator::velocity_verlet_implicit, 64), 2.0, 0.05);
}

// As far as round-off lets one see it.
TEST(SchemesInSingle, PefrlIsOfFourthOrderWhileItsErrorIsAboveRoundOff) {
  EXPECT_NEAR(std::log2(orbit_error(Precision::single_precision, Integrator::pefrl, 2) /
                        orbit_error(Precision::single_precision, Integrator::pefrl, 4)),
              4.0, 0.5);
}

TEST(SchemesSupport, WhatPefrlLacksIsRefusedWithAReason) {
  OpenClEngine engine(options_for(Precision::double_precision));
  const auto because = [&](const Scene& scene, bool ledger = false) {
    Request request;
    request.ledger = ledger;
    return engine.supports(scene, request).because;
  };
  Scene scene = head_on_scene(0.8, 64);
  scene.run.integrator = Integrator::pefrl;
  EXPECT_EQ(because(scene), "");
  EXPECT_NE(because(scene, true).find("ledger"), std::string::npos);
  Scene turning = scene;
  turning.gravity = RotatingGravity{9.81, 2.0};
  EXPECT_NE(because(turning).find("rotates"), std::string::npos);
  Scene moving = scene;
  moving.walls = {{"lift", 0, Plane{{-0.9, 0.0, 0.0}, Vec3::UnitX()}, Translating{{0.1, 0.0, 0.0}}}};
  EXPECT_NE(because(moving).find("walls"), std::string::npos);
  Scene many = scene;
  for (int i = 0; i < 70; ++i) many.particles.push_back(sphere(100 + i, {0.0, 0.0, 0.5}, Vec3::Zero(), 1e-3));
  EXPECT_NE(because(many).find("64 particles"), std::string::npos);
}

GRAINPROOF_IN_SINGLE_AND_DOUBLE(Schemes);

}  // namespace
}  // namespace grainproof::opencl::testing
