// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

// One particle in a uniform stream: a(v) = r (u − v), with r h = 0.25 exact in binary.
constexpr double step = 0.5, rate = 0.5;
const Vec3 stream(2.0, 0.0, 0.0), start_velocity(1.0, -1.0, 0.5), gravity(0.0, 0.0, -2.0);
constexpr double tolerance = 1e-15;  // a few last digits of numbers of order 1

Scene in_stream(Integrator integrator) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), step);
  scene.run.integrator = integrator;
  scene.materials[0].density = 18.0;
  scene.flow = UniformFlow{rate * 0.25, stream};  // 18 μ/(18 d²) with d = 0.5
  scene.gravity = ConstantGravity{gravity};
  add_particle(scene, 0.5, Vec3::Zero(), start_velocity);
  return scene;
}

Vec3 acceleration(const Vec3& velocity) {
  return rate * (stream - velocity) + gravity;
}

void expect_frame(const Scene& scene, std::int64_t steps, const Vec3& position, const Vec3& velocity) {
  const Frame frame = frame_after(scene, steps);
  EXPECT_LE((frame.position[0] - position).norm(), tolerance);
  EXPECT_LE((frame.velocity[0] - velocity).norm(), tolerance);
}

TEST(Integrators, EulerTrapezoidTakesTheMeanVelocity) {
  const Vec3 v1 = start_velocity + acceleration(start_velocity) * step;
  expect_frame(in_stream(Integrator::euler_trapezoid), 1, 0.5 * step * (start_velocity + v1), v1);
}

TEST(Integrators, ImplicitDragActsWithTheNewVelocity) {
  const Vec3 v1 = (start_velocity + gravity * step + 0.25 * stream) / 1.25;
  expect_frame(in_stream(Integrator::euler_trapezoid_implicit_drag), 1, 0.5 * step * (start_velocity + v1),
               v1);
}

TEST(Integrators, VelocityVerletDampsWithTheHalfStepVelocity) {
  const Vec3 half = start_velocity + acceleration(start_velocity) * (0.5 * step);
  const Vec3 v1 = half + acceleration(half) * (0.5 * step);
  expect_frame(in_stream(Integrator::velocity_verlet), 1, half * step, v1);
}

TEST(Integrators, PredictedVelocityIsWhatForcesSee) {
  const Vec3 kick = acceleration(start_velocity) * (0.5 * step), half = start_velocity + kick;
  const Vec3 v1 = half + acceleration(half + kick) * (0.5 * step);
  expect_frame(in_stream(Integrator::velocity_verlet_predicted), 1, half * step, v1);
  expect_frame(in_stream(Integrator::onset_corrected), 1, half * step, v1);
}

// Sweetman 2.19: the reported velocity is the mean of the two half-step velocities around it.
TEST(Integrators, LeapfrogReportsTheMeanOfItsHalfStepVelocities) {
  const Vec3 half = start_velocity + acceleration(start_velocity) * (0.5 * step);
  const Vec3 next = half + acceleration(half) * step;
  expect_frame(in_stream(Integrator::leapfrog_verlet), 0, Vec3::Zero(), start_velocity);
  expect_frame(in_stream(Integrator::leapfrog_verlet), 1, half * step, 0.5 * (half + next));
  const Vec3 after = next + acceleration(next) * step;
  expect_frame(in_stream(Integrator::leapfrog_verlet), 2, (half + next) * step, 0.5 * (next + after));
}

TEST(Integrators, LeapfrogStateIsHalfAStepBehindOnceItHasStarted) {
  const auto run = start(in_stream(Integrator::leapfrog_verlet));
  EXPECT_EQ(run->state().velocity_lag, 0.0);
  run->advance(1);
  EXPECT_EQ(run->state().velocity_lag, 0.5);
  const Vec3 half = start_velocity + acceleration(start_velocity) * (0.5 * step);
  EXPECT_LE((run->state().velocity[0] - half).norm(), tolerance);
}

/// Distance from the finest run of a smooth path in a rotating field; forces depend on place and time.
double error_at(Integrator integrator, int steps) {
  const auto end_position = [integrator](int count) {
    Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1.0 / count);
    scene.run.integrator = integrator;
    scene.gravity = CentralGravity{1.0, {0.0, 0.0, 0.0}};
    add_particle(scene, 0.1, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.2});
    return frame_after(scene, count).position[0];
  };
  return (end_position(steps) - end_position(64 * steps)).norm();
}

double order_of(Integrator integrator) {
  return std::log2(error_at(integrator, 64) / error_at(integrator, 128));
}

// Measured against a run of 64 times the steps, which bends the order by at most 1/64.
TEST(Integrators, OrdersInASmoothField) {
  EXPECT_NEAR(order_of(Integrator::euler_trapezoid), 1.0, 0.05);
  EXPECT_NEAR(order_of(Integrator::velocity_verlet), 2.0, 0.05);
  EXPECT_NEAR(order_of(Integrator::leapfrog_verlet), 2.0, 0.05);
}

// Without velocity in the force both Verlet schemes are the same map; sums of 1000 steps of order 1.
TEST(Integrators, VerletFormsAgreeOnAConservativePath) {
  const auto at_end = [](Integrator integrator) {
    Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1e-3);
    scene.run.integrator = integrator;
    scene.gravity = CentralGravity{1.0, {0.0, 0.0, 0.0}};
    add_particle(scene, 0.1, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.2});
    return frame_after(scene, 1000);
  };
  const Frame one = at_end(Integrator::velocity_verlet), two = at_end(Integrator::leapfrog_verlet);
  EXPECT_LE((one.position[0] - two.position[0]).norm(), 1e-12);
  EXPECT_LE((one.velocity[0] - two.velocity[0]).norm(), 1e-12);
}

TEST(Integrators, TimeIsStepsTimesStepAndNeverASum) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 0.1);
  add_particle(scene, 0.1, Vec3::Zero());
  EXPECT_EQ(frame_after(scene, 1000).time, 1000 * 0.1);
}

}  // namespace
}  // namespace grainproof::testing
