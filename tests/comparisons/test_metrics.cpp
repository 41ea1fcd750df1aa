// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>

#include "comparisons/quantity.hpp"
#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One particle on a path along x, seen at every step.
Observations path(const Scene& scene, const std::function<double(double)>& x,
                  const std::function<double(double)>& v) {
  Observations seen;
  const std::int64_t last = step_at_or_after(scene.run.end, scene.run.step);
  for (std::int64_t n = 0; n <= last; ++n) {
    const double t = static_cast<double>(n) * scene.run.step;
    seen.frames.push_back({n, t, {Vec3(x(t), 0.0, 0.0)}, {Vec3(v(t), 0.0, 0.0)}});
  }
  return seen;
}

Measured error(const char* name, const Scene& scene, const Observations& seen, const Observations& exact) {
  return quantity_named(name)->error(scene, seen, exact);
}

Observations telling(const char* name, double value) {
  Observations exact;
  exact.scalars[name] = value;
  return exact;
}

Scene flight() {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{0.8}}}, 10.0);
  scene.particles = {particle(1, Vec3::Zero(), Vec3(3.0, 0.0, 0.0))};
  run_for(scene, 1.0, 0.01);
  return scene;
}

TEST(Quantities, HaveNamesOfTheirOwn) {
  for (const Quantity& quantity : quantities()) {
    EXPECT_EQ(quantity_named(quantity.name), &quantity);
    EXPECT_EQ((quantity.value != nullptr) + (quantity.compare != nullptr) + (quantity.search != nullptr), 1)
        << quantity.name;
    EXPECT_FALSE(quantity.relative_to.empty()) << quantity.name;
  }
  EXPECT_EQ(quantity_named("colour"), nullptr);
}

TEST(Quantities, AreAllInTheDocumentation) {
  for (const char* page : {"docs/scene.md", "docs/verdicts.md"}) {
    std::ifstream in(page);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    for (const Quantity& quantity : quantities())
      EXPECT_NE(text.find(std::string("`").append(quantity.name).append("`")), std::string::npos)
          << page << ": " << quantity.name;
  }
}

TEST(Position, ErrorIsRelativeToThePathAndPositiveAhead) {
  const Scene scene = flight();
  const Observations exact = path(
      scene, [](double t) { return 3.0 * t; }, [](double) { return 3.0; });
  const auto off_by = [&](double part) {
    const Observations seen = path(
        scene, [&](double t) { return 3.0 * t * (1.0 + part); }, [](double) { return 3.0; });
    return error("position", scene, seen, exact).value;
  };
  EXPECT_NEAR(off_by(1e-3), 1e-3, 1e-15);
  EXPECT_NEAR(off_by(-1e-3), -1e-3, 1e-15);
}

TEST(Position, IsRelativeToTheWayThereAndBackOfABounce) {
  Scene scene = flight();
  const auto there_and_back = [](double t) { return t < 0.5 ? t : 1.0 - t; };
  const Observations exact = path(scene, there_and_back, [](double t) { return t < 0.5 ? 1.0 : -1.0; });
  Observations seen = exact;
  seen.frames.back().position[0].x() += 1e-3;
  EXPECT_NEAR(std::abs(error("position", scene, seen, exact).value), 1e-3, 1e-14);
  Observations ends = exact;
  ends.frames = {exact.frames.front(), exact.frames.back()};
  Observations seen_ends = ends;
  seen_ends.frames.back().position[0].x() += 1e-3;
  EXPECT_NEAR(std::abs(error("position", scene, seen_ends, ends).value), 1e-3, 1e-14);
}

TEST(Position, GoesTheShortWayAroundAPeriodicBox) {
  Scene scene = flight();
  scene.domain.boundary[0] = Boundary::periodic;
  Observations exact;
  exact.frames = {{0, 0.0, {Vec3(9.5, 0, 0)}, {Vec3(1, 0, 0)}},
                  {100, 1.0, {Vec3(-9.5, 0, 0)}, {Vec3(1, 0, 0)}}};
  Observations seen = exact;
  seen.frames[1].position[0].x() = 9.99;
  EXPECT_NEAR(error("position", scene, seen, exact).value, -0.51, 1e-12);
}

TEST(Position, FramesAtOtherTimesAreNotCompared) {
  const Scene scene = flight();
  const Observations exact = path(
      scene, [](double t) { return t; }, [](double) { return 1.0; });
  Observations late = exact;
  late.frames.back().time += scene.run.step;
  EXPECT_FALSE(error("position", scene, late, exact).exists());
  Observations fewer = exact;
  fewer.frames.pop_back();
  EXPECT_FALSE(error("velocity", scene, fewer, exact).exists());
}

TEST(Velocity, ErrorIsRelativeToTheLargestSpeedHoweverSmallThatIs) {
  const Scene scene = flight();
  const Observations exact = path(
      scene, [](double) { return 0.0; }, [](double t) { return 1e-9 * t; });
  const Observations seen = path(
      scene, [](double) { return 0.0; }, [](double t) { return 0.9e-9 * t; });
  EXPECT_NEAR(error("velocity", scene, seen, exact).value, -0.1, 1e-12);
}

TEST(Velocity, HasNoScaleWhereNothingMoves) {
  const Scene scene = flight();
  const auto still = [](double) { return 0.0; };
  const Observations exact = path(scene, still, still);
  EXPECT_FALSE(error("velocity", scene, path(scene, still, [](double) { return 1e-9; }), exact).exists());
  EXPECT_EQ(error("velocity", scene, exact, exact).value, 0.0);
}

TEST(KineticEnergy, IsRootMeanSquareOverTheFramesRelativeToTheLargest) {
  const Scene scene = flight();
  Observations exact;
  exact.frames = {{0, 0, {Vec3::Zero()}, {Vec3(2, 0, 0)}}, {50, 0.5, {Vec3::Zero()}, {Vec3(0, 0, 0)}}};
  Observations seen = exact;
  seen.frames[1].velocity[0].x() = 1.0;  // a quarter of the largest energy, in one frame of two
  EXPECT_NEAR(error("kinetic_energy", scene, seen, exact).value, 0.25 / std::sqrt(2.0), 1e-15);
}

/// A damped half oscillation with a fixed sphere that begins `onset` after the start, sampled at every step.
struct HalfOscillation {
  Scene scene;
  Observations seen;
  double onset;
  double beta = dashpot(0.8, mass(), stiffness) / (2.0 * mass());
  double omega = std::sqrt(stiffness / mass() - beta * beta);
  double duration = std::numbers::pi / omega;

  explicit HalfOscillation(double steps, double phase) : scene(collision_with_fixed(steps, phase)) {
    onset = phase * scene.run.step;
    const std::int64_t last = step_at_or_after(scene.run.end, scene.run.step);
    for (std::int64_t n = 0; n <= last; ++n) seen.frames.push_back(frame(n));
  }
  Frame frame(std::int64_t n) const {
    const double time = static_cast<double>(n) * scene.run.step;
    const double t = time - onset;
    double x = 0.1 - 2.0 * t;
    double v = -2.0;
    if (t > duration) {
      v = 2.0 * 0.8;
      x = 0.1 + v * (t - duration);
    } else if (t > 0.0) {
      x = 0.1 - 2.0 / omega * std::exp(-beta * t) * std::sin(omega * t);
      v = -2.0 * std::exp(-beta * t) * (std::cos(omega * t) - beta / omega * std::sin(omega * t));
    }
    return {n, time, {Vec3::Zero(), Vec3(x, 0.0, 0.0)}, {Vec3::Zero(), Vec3(v, 0.0, 0.0)}};
  }
  double peak() const {
    const double t = std::atan2(omega, beta) / omega;
    return 2.0 / omega * std::exp(-beta * t) * std::sin(omega * t);
  }
};

TEST(Restitution, IsExactOnTheExactPath) {
  const HalfOscillation exact(16.3, 0.3);
  EXPECT_NEAR(error("restitution", exact.scene, exact.seen, telling("restitution", 0.8)).value, 0.0, 1e-14);
  EXPECT_NEAR(error("restitution", exact.scene, exact.seen, telling("restitution", 1.0)).value, -0.2, 1e-14);
}

TEST(Restitution, ExactZeroHasTheApproachSpeedAsItsScale) {
  const HalfOscillation exact(16.3, 0.3);
  EXPECT_NEAR(error("restitution", exact.scene, exact.seen, telling("restitution", 0.0)).value, 0.8, 1e-14);
}

TEST(Restitution, DoesNotExistWhileTheBodiesStillTouch) {
  HalfOscillation exact(16.3, 0.3);
  exact.seen.frames.resize(10);
  EXPECT_FALSE(error("restitution", exact.scene, exact.seen, telling("restitution", 0.8)).exists());
}

TEST(Restitution, TwoFreeBodiesAndWallsHaveOne) {
  Scene pair = collision_with_fixed(16.0, 0.5);
  pair.particles[0].fixed = false;
  Observations seen;
  seen.frames = {{0, 0.0, {Vec3::Zero(), Vec3(0.2, 0, 0)}, {Vec3(1, 0, 0), Vec3(-2, 0, 0)}},
                 {1, 1.0, {Vec3(-1, 0, 0), Vec3(1, 0, 0)}, {Vec3(-1, 0, 0), Vec3(0.5, 0, 0)}}};
  EXPECT_NEAR(error("restitution", pair, seen, telling("restitution", 0.5)).value, 0.0, 1e-15);
  Scene wall = flight();
  wall.walls = {{"w", 0, Plane{Vec3(1.0, 0, 0), Vec3(-1, 0, 0)}}};
  seen.frames = {{0, 0.0, {Vec3::Zero()}, {Vec3(3, 1, 0)}},
                 {1, 1.0, {Vec3(0.5, 0.3, 0)}, {Vec3(-1.5, 0.75, 0)}}};
  EXPECT_NEAR(error("restitution", wall, seen, telling("restitution", 0.5)).value, 0.0, 1e-15);
  EXPECT_NEAR(
      error("tangential_velocity_change", wall, seen, telling("tangential_velocity_change", 0.25)).value, 0.0,
      1e-15);
}

// The ends are found by straight flight, which is exact here.
TEST(ContactDuration, IsExactOnTheExactPathAtAnyStepAndPhase) {
  for (const double steps : {8.3, 16.0, 100.7})
    for (const double phase : {0.1, 0.5, 0.9}) {
      const HalfOscillation exact(steps, phase);
      const Measured off =
          error("contact_duration", exact.scene, exact.seen, telling("contact_duration", exact.duration));
      EXPECT_NEAR(off.value, 0.0, 1e-12) << steps << ' ' << phase;
    }
}

TEST(PeakOverlap, InterpolatesToFourthOrderInTheStep) {
  double coarse = 0.0;
  double fine = 0.0;
  for (const double phase : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const auto off = [&](double steps) {
      const HalfOscillation exact(steps, phase);
      return std::abs(
          error("peak_overlap", exact.scene, exact.seen, telling("peak_overlap", exact.peak())).value);
    };
    coarse = std::max(coarse, off(10.0));
    fine = std::max(fine, off(40.0));
  }
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 3.5);
}

TEST(RestingOverlap, IsRelativeToTheOverlapItself) {
  Scene scene = flight();
  scene.walls = {{"floor", 0, Plane{Vec3::Zero(), Vec3::UnitX()}}};
  Observations seen;
  seen.frames = {{0, 0.0, {Vec3(0.05, 0, 0)}, {Vec3::Zero()}},
                 {1, 1.0, {Vec3(0.05 - 1.01e-4, 0, 0)}, {Vec3::Zero()}}};
  EXPECT_NEAR(error("resting_overlap", scene, seen, telling("resting_overlap", 1e-4)).value, 1e-2, 1e-12);
}

TEST(Stopping, TimeIsInterpolatedAndDistanceIsWhatWasTravelled) {
  Scene scene = flight();
  const auto v = [](double t) { return t < 0.515 ? 3.0 * (1.0 - t / 0.505) : -1e-6; };  // overshoots
  const auto x = [](double t) { return 3.0 * (t < 0.505 ? t - t * t / 1.01 : 0.2525); };
  const Observations seen = path(scene, x, v);
  EXPECT_NEAR(error("stop_time", scene, seen, telling("stop_time", 0.505)).value, 0.0, 1e-13);
  EXPECT_NEAR(error("stop_distance", scene, seen, telling("stop_distance", 0.7575)).value, 0.0, 1e-13);
  const Observations creeping = path(scene, x, [](double t) { return std::exp(-t); });
  EXPECT_FALSE(error("stop_time", scene, creeping, telling("stop_time", 0.505)).exists());
}

TEST(RelativeError, OfAnExactZeroDoesNotExist) {
  EXPECT_FALSE(relative_error(Measured::of(1e-3), Measured::of(0.0)).exists());
  EXPECT_TRUE(std::isnan(relative_error(Measured::of(nan), Measured::of(1.0)).value));
}

}  // namespace
}  // namespace grainproof::test
