// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "comparisons/judge.hpp"
#include "comparisons/searches/bisection.hpp"
#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {
namespace {

TEST(Bisection, FindsThresholdsFarFromTheGuessAllAtOnce) {
  const std::vector<double> thresholds{1e-3, 1.0, 1.01, 5e4};
  const std::vector<double> guesses(4, 1.0);
  int rounds = 0;
  const std::vector<Measured> found = bisect(guesses, 0.02, 1e-6, [&](std::span<const Trial> trials) {
    ++rounds;
    std::vector<Side> sides;
    for (const Trial& trial : trials) sides.push_back({trial.at > thresholds[trial.unknown], {}});
    return sides;
  });
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i].value / thresholds[i], 1.0, 1e-6);
  EXPECT_LT(rounds, 60);
}

TEST(Bisection, GivesUpWhereThereIsNoThreshold) {
  const std::vector<double> guesses{1.0, 1.0};
  const std::vector<Measured> found = bisect(guesses, 0.02, 1e-6, [](std::span<const Trial> trials) {
    std::vector<Side> sides;
    for (const Trial& trial : trials) sides.push_back({trial.unknown == 0, {}});
    return sides;
  });
  EXPECT_FALSE(found[0].exists());
  EXPECT_FALSE(found[1].exists());
}

/// Lets a particle escape if it hits the effect surface faster than `threshold`; checks the onset's phase.
class StickyWall : public Engine {
 public:
  std::string name() const override { return "sticky"; }
  Support supports(const Scene&, const Request&) const override { return {}; }
  Observations observe(const Scene& scene, const Request&) override {
    const Particle& p = scene.particles[1];
    const double speed = -p.velocity.x();
    phases.push_back((p.position.x() - 0.12) / (speed * scene.run.step));
    Observations seen;
    const bool leaves = speed > threshold;
    seen.frames = {{0, 0.0, {Vec3::Zero(), p.position}, {Vec3::Zero(), p.velocity}},
                   {1,
                    scene.run.end,
                    {Vec3::Zero(), Vec3(leaves ? 0.13 : 0.11, 0, 0)},
                    {Vec3::Zero(), Vec3(0.1, 0, 0)}}};
    return seen;
  }
  double threshold = 0.4321;
  std::vector<double> phases;
};

Case sticking() {
  Case subject;
  for (int sample = 0; sample < 4; ++sample) {
    Scene scene = collision_with_fixed(64.0, 0.0);
    for (Particle& p : scene.particles) p.effect_diameter = 0.12;
    scene.particles[1].position.x() = 0.12 + 2.0 * (sample + 0.5) / 4.0 * scene.run.step;
    subject.scenes.push_back({scene, {"contact/64", 64.0, sample, {}}});
  }
  Expectation says;
  says.quantity = "sticking_speed";
  says.against = "value:0.4321";
  says.below = {{"", 1e-5}};
  subject.expectations = {says, says};
  subject.expectations[1].statistic = Statistic::rms;
  return subject;
}

TEST(StickingSpeed, IsFoundAndKeepsThePhaseOfTheOnset) {
  StickyWall engine;
  const std::vector<Row> rows = judge(sticking(), engine, {});
  ASSERT_EQ(rows.size(), 2u);
  for (const Row& row : rows) EXPECT_EQ(row.verdict, Verdict::pass) << row.reason;
  const std::size_t runs = engine.phases.size();
  EXPECT_LT(runs, 4 * 20u);  // both claims share one search
  for (const double phase : engine.phases) EXPECT_NEAR(std::fmod(phase, 0.25), 0.125, 1e-9);
  engine.threshold = 0.4330;
  for (const Row& row : judge(sticking(), engine, {})) EXPECT_EQ(row.verdict, Verdict::fail);
}

/// A particle on a floor whose velocity amplitude changes by the factor `growth` a step.
class Oscillator : public Engine {
 public:
  std::string name() const override { return "oscillator"; }
  Support supports(const Scene&, const Request&) const override { return {}; }
  Observations observe(const Scene& scene, const Request& request) override {
    Observations seen;
    for (const std::int64_t n : sample_steps(scene, request)) {
      const double growth = 1.0 + 0.04 * (scene.run.step / limit - 1.0);
      const double amplitude = std::min(0.03 * std::pow(growth, static_cast<double>(n)), ceiling);
      const double v = amplitude * std::cos(300.0 * scene.run.step * static_cast<double>(n));
      seen.frames.push_back(
          {n, static_cast<double>(n) * scene.run.step, {Vec3(0, 0, 0.0499)}, {Vec3(0, 0, v)}});
      if (!std::isfinite(v)) seen.outcome = {Outcome::Status::went_wrong, "too fast", n, 0.0, {1}};
    }
    return seen;
  }
  double limit = 9.17e-4;
  double ceiling = HUGE_VAL;
};

TEST(StableStep, IsFoundWhetherTheMotionExplodesOrIsBounded) {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{0.8}}});
  scene.particles = {particle(1, Vec3(0, 0, 0.05), Vec3::Zero())};
  run_for(scene, 10.0, 1.6e-4);
  Case subject;
  subject.scenes = {{scene, {"contact/64", 64.0, 0, {}}}};
  Expectation says;
  says.quantity = "stable_step";
  says.against = "value:9.17e-4";
  says.below = {{"", 1e-3}};
  subject.expectations = {says};
  Oscillator engine;
  for (const double ceiling : {HUGE_VAL, 0.031}) {
    engine.ceiling = ceiling;
    const std::vector<Row> rows = judge(subject, engine, {});
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].verdict, Verdict::pass) << rows[0].reason;
  }
  engine.limit = 9.0e-4;
  EXPECT_EQ(judge(subject, engine, {})[0].verdict, Verdict::fail);
}

}  // namespace
}  // namespace grainproof::test
