// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "device_fixture.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr double fluid_viscosity = 0.00193, thin = 10.0;
const double tau = thin * diameter * diameter / (18 * fluid_viscosity);

Scene drag_scene(Integrator integrator, double step) {
  Scene scene = empty_scene(0.8);
  scene.domain = {Vec3(-1, -1, -1), Vec3(30, 1, 1), {}};
  scene.materials[0].density = thin;
  scene.flow = UniformFlow{fluid_viscosity, {1, 0, 0}};
  scene.particles = {sphere(0, Vec3::Zero(), Vec3::Zero())};
  scene.run.integrator = integrator;
  scene.run.step = step;
  scene.run.end = tau;
  scene.run.sample_times = {0.0, scene.run.end};
  return scene;
}

class Fields : public ::testing::TestWithParam<Precision> {
 protected:
  double drag_error(Integrator integrator, double steps) {
    const auto seen = observed(options_for(GetParam()), drag_scene(integrator, tau / steps));
    const Frame& last = seen.frames.back();
    return last.velocity[0].x() - (1 - std::exp(-last.time / tau));
  }
};

TEST_P(Fields, ExplicitDragOverestimatesAndImplicitUnderestimatesAtFirstOrder) {
  for (const auto& [integrator, sign] : {std::pair{Integrator::euler_trapezoid, 1.0},
                                         std::pair{Integrator::euler_trapezoid_implicit_drag, -1.0}}) {
    const double coarse = sign * drag_error(integrator, 64), fine = sign * drag_error(integrator, 128);
    EXPECT_GT(fine, 0.0);
    EXPECT_LE(std::abs(std::log2(coarse / fine) - 1.0), 0.05);
  }
}

TEST_P(Fields, FreeFallIsExactInEveryIntegrator) {
  for (const auto& [name, integrator] : integrator_names) {
    Scene scene = empty_scene(0.8);
    scene.gravity = ConstantGravity{{1, 2, -9.81}};
    scene.particles = {sphere(0, {0, 0, 0.9}, Vec3::Zero())};
    scene.run.end = 0.4;
    scene.run.step = 1e-5;
    scene.run.integrator = integrator;
    scene.run.sample_times = {0.0, 0.4};
    const Frame last = observed(options_for(GetParam()), scene).frames.back();
    const Vec3 expected = Vec3(0, 0, 0.9) + Vec3(1, 2, -9.81) * last.time * last.time / 2;
    // 40 000 steps: what is lost a step must not add up. Double has no rest of velocity, so half a digit a
    // step.
    const double steps = GetParam() == Precision::double_precision ? 40'000 : 4;
    EXPECT_LE((last.position[0] - expected).norm(), steps * roundoff(GetParam())) << name;
    EXPECT_LE((last.velocity[0] - Vec3(1, 2, -9.81) * last.time).norm(), 10 * steps * roundoff(GetParam()))
        << name;
  }
}

/// Andrews 6.1-6.3 as printed.
Vec3 taylor_green(const TaylorGreenFlow& flow, const Vec3& x) {
  const Vec3 p = flow.wave_number * x + Vec3::Constant(M_PI / 2);
  return flow.amplitude * Vec3(std::cos(p[0]) * std::sin(p[1]) * std::sin(p[2]),
                               std::sin(p[0]) * std::cos(p[1]) * std::sin(p[2]),
                               -2 * std::sin(p[0]) * std::sin(p[1]) * std::cos(p[2]));
}

TEST_P(Fields, OneStepInVorticesFollowsThePrintedFlow) {
  const TaylorGreenFlow flow{fluid_viscosity, 2.0, 7.5};
  for (int i = 0; i < 30; ++i) {
    Scene scene = drag_scene(Integrator::euler_trapezoid, tau / 100);
    const Vec3 at(0.97 * i, 0.9 - 0.06 * i, -0.9 + 0.055 * i);
    scene.flow = flow;
    scene.particles = {sphere(0, at, Vec3::Zero())};
    scene.run.end = scene.run.step;
    scene.run.sample_times = {0.0, scene.run.end};
    const Vec3 seen = observed(options_for(GetParam()), scene).frames.back().velocity[0] * 100;
    // 16 roundings of 2 A; in double also those of a phase of up to 230.
    EXPECT_LE((seen - taylor_green(flow, at)).norm(),
              16 * 4 * roundoff(GetParam()) + 230 * 8 * double_roundoff);
  }
}

TEST_P(Fields, CentralGravityPullsTowardsItsCentreOnly) {
  Scene scene = empty_scene(0.8);
  scene.gravity = CentralGravity{9.81, {0.1, 0.2, 0.3}};
  scene.particles = {sphere(0, {0.1, 0.2, 0.3}, Vec3::Zero()), sphere(1, {0.4, -0.2, 0.3}, Vec3::Zero())};
  scene.run.end = scene.run.step = 1e-4;
  scene.run.integrator = Integrator::euler_trapezoid;
  scene.run.sample_times = {0.0, 1e-4};
  const Frame last = observed(options_for(GetParam()), scene).frames.back();
  EXPECT_EQ(last.velocity[0], Vec3::Zero());
  EXPECT_LE((last.velocity[1] / 1e-4 - 9.81 * Vec3(-0.6, 0.8, 0)).norm(), 9.81 * 8 * roundoff(GetParam()));
}

TEST_P(Fields, RotatingGravityPointsWhereItsEquationSays) {
  Scene scene = empty_scene(0.8);
  scene.gravity = RotatingGravity{9.81, 0.05};
  scene.particles = {sphere(0, Vec3::Zero(), Vec3::Zero())};
  scene.run.end = 0.1;
  scene.run.step = 1e-3;
  scene.run.integrator = Integrator::euler_trapezoid;
  scene.run.sample_times = {0.0, 0.1};
  Vec3 expected = Vec3::Zero();
  for (int n = 0; n < 100; ++n) {
    const double angle = std::pow(n * 1e-3 / 0.05, 2);
    expected += 1e-3 * 9.81 * Vec3(std::sin(angle), -std::cos(angle), 0);
  }
  const Frame last = observed(options_for(GetParam()), scene).frames.back();
  EXPECT_LE((last.velocity[0] - expected).norm(), 100 * roundoff(GetParam()));
}

GRAINPROOF_IN_EVERY_PRECISION(Fields);

}  // namespace
}  // namespace grainproof::opencl::testing
