// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "model/errors.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// What went wrong within `steps` steps; the test fails when nothing does.
RunWentWrong failure_of(Run& run, std::int64_t steps) {
  try {
    run.advance(steps);
  } catch (const RunWentWrong& failure) {
    return failure;
  }
  ADD_FAILURE() << "the run went on";
  return RunWentWrong("nothing", 0, 0.0, {});
}

bool says(const RunWentWrong& failure, const std::string& words) {
  return std::string(failure.what()).find(words) != std::string::npos;
}

Scene closing_pair(double speed, double step) {
  Scene scene = empty_scene(linear(1e4, Restitution{0.8}), step);
  add_particle(scene, 0.1, {0.0, 0.0, 0.0}).fixed = true;
  add_particle(scene, 0.1, {0.11, 0.0, 0.0}, {-speed, 0.0, 0.0});
  return scene;
}

TEST(Failures, ParticleThatLeavesIsNamedWithStepAndTime) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 0.25);
  add_particle(scene, 0.1, {1.0, 0.0, 0.0});
  add_particle(scene, 0.1, {0.0, 9.8, 0.0}, {0.0, 0.19, 0.0});
  const auto run = start(scene);
  const RunWentWrong failure = failure_of(*run, 10);
  EXPECT_EQ(failure.step, 5);
  EXPECT_EQ(failure.time, 1.25);
  EXPECT_EQ(failure.particles, std::vector<std::int64_t>{2});
  EXPECT_TRUE(says(failure, "particle 2 left the domain")) << failure.what();
}

// 0.051 m a step: past a radius of 0.05 m.
TEST(Failures, ParticleThatMayLeapOverAnotherIsNamed) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 0.25);
  add_particle(scene, 0.1, {0.0, 0.0, 0.0}, {0.204, 0.0, 0.0});
  const auto alone = start(scene);
  EXPECT_NO_THROW(alone->advance(3));
  add_particle(scene, 0.1, {1.0, 0.0, 0.0});
  const auto run = start(scene);
  const RunWentWrong failure = failure_of(*run, 10);
  EXPECT_EQ(failure.step, 1);
  EXPECT_EQ(failure.particles, std::vector<std::int64_t>{1});
  EXPECT_TRUE(says(failure, "moved by more than its radius in one step")) << failure.what();
}

TEST(Failures, NotANumberIsFoundAtOnce) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 0.25);
  add_particle(scene, 0.1, Vec3::Zero(), {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
  const auto run = start(scene);
  const RunWentWrong failure = failure_of(*run, 10);
  EXPECT_EQ(failure.step, 1);
  EXPECT_TRUE(says(failure, "particle 1 has a position or velocity that is not a number")) << failure.what();
}

// Undamped contact time of 1.047 kg on 1e4 N/m: 0.032 s. At 2 m/s a step of 0.02 s enters by 0.03 m.
TEST(Failures, DeepOverlapAtALargeStepBlamesTheStep) {
  const auto run = start(closing_pair(2.0, 0.02));
  const RunWentWrong failure = failure_of(*run, 10);
  EXPECT_EQ(failure.particles, (std::vector<std::int64_t>{1, 2}));
  EXPECT_TRUE(says(failure, "particles 1 and 2 overlap")) << failure.what();
  EXPECT_TRUE(says(failure, "step too large")) << failure.what();
}

TEST(Failures, DeepOverlapAtASmallStepBlamesTheImpact) {
  const auto run = start(closing_pair(20.0, 1e-5));
  const RunWentWrong failure = failure_of(*run, 1000);
  EXPECT_TRUE(says(failure, "impact too fast")) << failure.what();
  EXPECT_NEAR(0.1 - (run->frame().position[1] - run->frame().position[0]).norm(), 0.025, 20.0 * 1e-5);
}

// 0.012 m is 0.24 of the radius 0.05 and 0.4 of the radius 0.03.
TEST(Failures, LimitIsAShareOfTheSmallerRadius) {
  Scene scene = closing_pair(0.0, 1e-5);
  scene.particles[1].diameter = scene.particles[1].effect_diameter = 0.06;
  scene.particles[1].position.x() = 0.08 - 0.012;
  scene.run.overlap_limit = 0.41;
  EXPECT_NO_THROW(start(scene)->advance(1));
  scene.run.overlap_limit = 0.39;
  EXPECT_THROW(start(scene)->advance(1), RunWentWrong);
}

TEST(Failures, WallIsNamed) {
  Scene scene = closing_pair(20.0, 1e-5);
  scene.particles.erase(scene.particles.begin());
  scene.walls.push_back({"shutter", 0, Rectangle{{0.0, -1.0, -1.0}, {0.0, 1.0, 1.0}}});
  const auto run = start(scene);
  const RunWentWrong failure = failure_of(*run, 1000);
  EXPECT_TRUE(says(failure, "particle 2 overlaps the wall 'shutter'")) << failure.what();
  EXPECT_EQ(failure.particles, std::vector<std::int64_t>{2});
}

TEST(Failures, OverlapAtTheStartIsToldAtTheFirstStep) {
  Scene scene = closing_pair(1.0, 1e-5);
  scene.particles[1].position.x() = 0.05;
  const auto run = start(scene);
  EXPECT_NO_THROW(run->advance(0));
  EXPECT_EQ(failure_of(*run, 1).step, 0);
}

TEST(Failures, LastStateIsStillThereAndTheRunStaysWrong) {
  const auto run = start(closing_pair(2.0, 0.02));
  const RunWentWrong failure = failure_of(*run, 10);
  const Frame frame = run->frame();
  EXPECT_EQ(frame.step, failure.step);
  EXPECT_TRUE(frame.position[1].allFinite());
  EXPECT_THROW(run->advance(1), RunWentWrong);
}

TEST(Failures, ObservationKeepsTheFramesUpToThere) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 0.25);
  scene.run.end = 2.5;
  add_particle(scene, 0.1, {0.0, 9.0, 0.0}, {0.0, 1.0, 0.0});
  reference::ReferenceEngine engine;
  const Observations seen = engine.observe(scene, {.times = {}, .every_step = true});
  EXPECT_EQ(seen.outcome.status, Outcome::Status::went_wrong);
  EXPECT_EQ(seen.outcome.step, 5);
  EXPECT_EQ(seen.frames.size(), 5u);
}

}  // namespace
}  // namespace grainproof::testing
