// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "tests/reference/scenes.hpp"

/// velocity_verlet_implicit and pefrl.
namespace grainproof::testing {
namespace {

constexpr double stiffness = 1e5, diameter = 0.1, weight_factor = 9.81;

/// On a floor, sunk in by `share` of what carries its weight.
Scene sunk(Integrator integrator, double damping, double share, double step) {
  Scene scene = empty_scene(linear(stiffness, Damping{damping}), step);
  scene.run.integrator = integrator;
  scene.gravity = ConstantGravity{{0.0, 0.0, -weight_factor}};
  const double rest = sphere_mass(diameter) * weight_factor / stiffness;
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, diameter, {0.0, 0.0, 0.5 * diameter - share * rest});
  return scene;
}

TEST(ImplicitDashpots, SolveOneContactAsTheTrapezoidRuleDoes) {
  const double eta = 300.0, h = 1e-3, m = sphere_mass(diameter);
  Scene scene = sunk(Integrator::velocity_verlet_implicit, eta, 3.0, h);
  scene.particles[0].velocity.z() = -0.2;
  const double z0 = scene.particles[0].position.z(), v0 = -0.2;
  const auto spring = [&](double z) { return stiffness * (0.5 * diameter - z) / m - weight_factor; };
  const double half = v0 + 0.5 * h * (spring(z0) - eta / m * v0), z1 = z0 + h * half;
  const double v1 = (half + 0.5 * h * spring(z1)) / (1.0 + 0.5 * h * eta / m);
  const Frame frame = frame_after(scene, 1);
  EXPECT_NEAR(frame.position[0].z(), z1, 1e-16);
  EXPECT_NEAR(frame.velocity[0].z(), v1, 1e-14);
}

TEST(ImplicitDashpots, LeaveTheOverlapThatCarriesABody) {
  const double overdamped = 100.0 * std::sqrt(stiffness * sphere_mass(diameter));
  const Scene scene = sunk(Integrator::velocity_verlet_implicit, overdamped, 1.0, 2e-3);
  EXPECT_LE(frame_after(scene, 1000).velocity[0].norm(), 1e-12);
  EXPECT_NEAR(frame_after(scene, 1000).position[0].z(), scene.particles[0].position.z(), 1e-15);
}

TEST(ImplicitDashpots, LetABodyComeToRestWhereVelocityVerletIsLost) {
  const double overdamped = 100.0 * std::sqrt(stiffness * sphere_mass(diameter));
  const double speed =
      frame_after(sunk(Integrator::velocity_verlet_implicit, overdamped, 1.5, 2e-3), 2000).velocity[0].norm();
  EXPECT_LE(speed, 1e-3);
  EXPECT_ANY_THROW(frame_after(sunk(Integrator::velocity_verlet, overdamped, 1.5, 2e-3), 2000));
}

/// Two spheres that a third presses on from both sides: every contact is solved for itself.
TEST(ImplicitDashpots, KeepMomentumWhereABodyHasSeveral) {
  Scene scene = empty_scene(linear(stiffness, Damping{200.0}), 1e-4);
  scene.run.integrator = Integrator::velocity_verlet_implicit;
  add_particle(scene, 0.1, {-0.099, 0.0, 0.0}, {1.0, 0.2, 0.0});
  add_particle(scene, 0.1, Vec3::Zero());
  add_particle(scene, 0.12, {0.03, 0.1, 0.01}, {0.0, -2.0, 0.3});
  EXPECT_LE((momentum(scene, frame_after(scene, 50)) - momentum(scene, frame_after(scene, 0))).norm(), 1e-14);
}

TEST(ImplicitDashpots, TakeDragAtTheVelocityThatItLeaves) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 0.5);
  scene.run.integrator = Integrator::velocity_verlet_implicit;
  scene.materials[0].density = 18.0;
  scene.flow = UniformFlow{0.5 * 0.25, Vec3(2.0, 0.0, 0.0)};  // a rate of 1/2
  add_particle(scene, 0.5, Vec3::Zero(), {1.0, 0.0, 0.0});
  const double half = 1.0 + 0.25 * 0.5 * (2.0 - 1.0);
  const double v1 = (half + 0.25 * 0.5 * 2.0) / (1.0 + 0.25 * 0.5);
  EXPECT_NEAR(frame_after(scene, 1).velocity[0].x(), v1, 1e-15);
}

/// Distance at the end from a run of 64 times the steps.
template <class Make>
double order_of(Make make, int steps) {
  const auto end = [&](int count) { return frame_after(make(count), count).position[0]; };
  const Vec3 exact = end(64 * steps);
  return std::log2((end(steps) - exact).norm() / (end(2 * steps) - exact).norm());
}

Scene orbit(Integrator integrator, int steps) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1.0 / steps);
  scene.run.integrator = integrator;
  scene.gravity = CentralGravity{1.0, {0.0, 0.0, 0.0}};
  add_particle(scene, 0.1, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.2});
  return scene;
}

TEST(Pefrl, IsOfFourthOrderInASmoothField) {
  EXPECT_NEAR(order_of([](int n) { return orbit(Integrator::pefrl, n); }, 8), 4.0, 0.1);
  EXPECT_NEAR(order_of([](int n) { return orbit(Integrator::velocity_verlet_implicit, n); }, 64), 2.0, 0.05);
}

/// Pressed onto a floor that its tangential spring sticks to, it swings up and down and to and fro.
Scene swinging(int steps, double damping_ratio) {
  Scene scene = sunk(Integrator::pefrl, 0.0, 1.0, 0.05 / steps);
  ContactLaws laws = linear(stiffness, Damping{damping_ratio == 0.0 ? 0.0 : 50.0});
  laws.friction = HistoryFriction{100.0, 3e4, damping_ratio};
  scene.contacts.set(0, 0, laws);
  scene.particles[0].velocity = {0.003, 0.001, 0.01};
  return scene;
}

// Two of the five drifts go backwards, and the spring with them: it stays as long as the body is off.
TEST(Pefrl, StretchesSpringsBackwardsSoThatTheyKeepItsOrder) {
  EXPECT_NEAR(order_of([](int n) { return swinging(n, 0.0); }, 32), 4.0, 0.1);
}

TEST(Pefrl, IsOfFirstOrderWithADashpot) {
  EXPECT_NEAR(order_of([](int n) { return swinging(n, 0.5); }, 64), 1.0, 0.1);
}

TEST(Pefrl, TakesMovingWallsAndTurningGravityAtTheTimesOfItsForces) {
  const auto carried = [](int steps) {
    Scene scene = sunk(Integrator::pefrl, 0.0, 1.0, 0.05 / steps);
    scene.walls[0].motion = Vibrating{{0.0, 0.0, 2e-5}, 7.0, 0.3};
    return scene;
  };
  EXPECT_NEAR(order_of(carried, 32), 4.0, 0.15);
  const auto turning = [](int steps) {
    Scene scene = orbit(Integrator::pefrl, steps);
    scene.gravity = RotatingGravity{9.81, 0.2};
    return scene;
  };
  EXPECT_NEAR(order_of(turning, 64), 4.0, 0.15);
}

TEST(Pefrl, RefusesALedgerWithAReason) {
  const reference::ReferenceEngine engine;
  const Scene scene = orbit(Integrator::pefrl, 8);
  EXPECT_TRUE(engine.supports(scene, {}));
  EXPECT_NE(engine.supports(scene, {.times = {}, .ledger = true}).because.find("boundary"),
            std::string::npos);
}

TEST(Schemes, SayHowOftenTheyEvaluateForces) {
  EXPECT_EQ(evaluations_a_step(Integrator::velocity_verlet), 1);
  EXPECT_EQ(evaluations_a_step(Integrator::velocity_verlet_implicit), 2);
  EXPECT_EQ(evaluations_a_step(Integrator::pefrl), 4);
}

}  // namespace
}  // namespace grainproof::testing
