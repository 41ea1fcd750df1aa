// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

double inertia(double d) {
  return 0.1 * sphere_mass(d) * d * d;
}

Scene turning_scene(const HistoryFriction& friction, Dissipation dissipation, double step) {
  ContactLaws laws = linear(1e5, dissipation);
  laws.friction = friction;
  Scene scene = empty_scene(laws, step);
  scene.rotation = true;
  return scene;
}

TEST(LedgerOfTurning, SpinIsKineticEnergy) {
  Scene scene = turning_scene({0.5, 8e4, 0.0}, Damping{0.0}, 1e-5);
  add_particle(scene, 0.1, Vec3::Zero(), {0.0, 2.0, 0.0}).angular_velocity = {3.0, 0.0, 4.0};
  const double expected = 0.5 * sphere_mass(0.1) * 4.0 + 0.5 * inertia(0.1) * 25.0;
  EXPECT_NEAR(start(scene, true)->ledger().kinetic, expected, 1e-15 * expected);
}

/// Sliding at 1 m/s on a floor in which it rests.
Scene slider(const HistoryFriction& friction) {
  Scene scene = turning_scene(friction, Restitution{0.3}, 1e-5);
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, 0.1, {0.0, 0.0, 0.05 - sphere_mass(0.1) * 9.81 / 1e5}, {1.0, 0.0, 0.0});
  return scene;
}

double energy_in_spring(Run& run, double stiffness) {
  return 0.5 * stiffness * run.state().contacts.at(0).tangential_displacement.squaredNorm();
}

// What rolls at 5/7 of the speed has 5/7 of the energy left; the spring is quiet by then. Where the limit binds
// the dashpot too, the forces of the start have already stretched the spring: that energy is lost as well.
TEST(LedgerOfTurning, SlidingIntoRollingTakesTwoSeventhsOfTheEnergy) {
  for (const CoulombLimit limit : {CoulombLimit::spring, CoulombLimit::spring_and_dashpot}) {
    const auto run = start(slider({0.3, 8e4, 1.0, limit}), true);
    const double before = run->ledger().kinetic, stretched = energy_in_spring(*run, 8e4);
    EXPECT_EQ(stretched > 0.0, limit == CoulombLimit::spring_and_dashpot);
    EXPECT_EQ(run->ledger().dissipated_tangential, 0.0);
    run->advance(40000);
    EXPECT_NEAR(run->ledger().dissipated_tangential, 2.0 / 7.0 * before + stretched, 1e-9 * before);
    EXPECT_NEAR(run->ledger().kinetic, 5.0 / 7.0 * before, 1e-9 * before);
  }
}

/// A sphere that strikes a floor obliquely and grips it, without any dashpot; it touches from the start.
Scene gripping(Integrator integrator, double step) {
  Scene scene = turning_scene({1e3, 8e4, 0.0}, Damping{0.0}, step);
  scene.run.integrator = integrator;
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, 0.1, {0.0, 0.0, 0.0499}, {1.0, 0.3, -1.0}).angular_velocity = {0.0, -10.0, 0.0};
  return scene;
}

/// Before the contact is half over, of the energy in the tangential spring.
double lost_by_gripping(Integrator integrator, int steps) {
  const auto run = start(gripping(integrator, 1.5e-3 / steps), true);
  run->advance(steps);
  const double stored = energy_in_spring(*run, 8e4);
  EXPECT_GT(stored, 1e-2);
  return std::abs(run->ledger().dissipated_tangential) / stored;
}

// Only where the normal stands still: between spheres the slip is that of the middle of a step in the
// tangent plane of its end, which is right to first order.
TEST(LedgerOfTurning, SpringThatGripsKeepsWhatItIsGivenUpToTheSquareOfTheStep) {
  for (const Integrator integrator : {Integrator::velocity_verlet, Integrator::leapfrog_verlet}) {
    EXPECT_LE(lost_by_gripping(integrator, 1000), 1e-5);
    const double order = std::log2(lost_by_gripping(integrator, 100) / lost_by_gripping(integrator, 200));
    EXPECT_NEAR(order, 2.0, 0.1);
  }
}

/// Turning, rubbing, sticky, damped Hertz contacts in a closed box.
Scene busy_scene(Integrator integrator) {
  Scene scene = empty_scene({}, 5e-5);
  scene.materials[0].elasticity = Elasticity{1e7, 0.3};
  scene.contacts.set(0, 0,
                     {.normal = HertzNormal{Restitution{0.7}},
                      .friction = HistoryFriction{0.4, 0.0, 1.0},
                      .cohesion = LinearCohesion{20.0}});
  scene.rotation = true;
  scene.run.integrator = integrator;
  scene.domain = {.lower = Vec3::Zero(), .upper = Vec3::Constant(0.6)};
  close_domain(scene);
  scene.gravity = ConstantGravity{{1.0, 0.0, -9.81}};
  Random random(31);
  for (int i = 0; i < 64; ++i) {
    const Vec3 site = 0.15 * (Vec3(i % 4, i / 4 % 4, i / 16) + Vec3::Constant(0.5));
    add_particle(scene, 0.13, site, random.in_box(Vec3::Constant(-2.0), Vec3::Constant(2.0)))
        .angular_velocity = random.in_box(Vec3::Constant(-9.0), Vec3::Constant(9.0));
  }
  return scene;
}

class TurningLedgerOf : public ::testing::TestWithParam<Integrator> {};

TEST_P(TurningLedgerOf, KeepingItChangesNoBit) {
  const auto with = start(busy_scene(GetParam()), true), without = start(busy_scene(GetParam()), false);
  with->advance(500);
  without->advance(500);
  EXPECT_GT(with->state().contacts.size(), 10u);
  EXPECT_EQ(with->digest(), without->digest());
}

double drift(Integrator integrator, double step, double end) {
  Scene scene = busy_scene(integrator);
  scene.run.step = step;
  const auto run = start(scene, true);
  const Ledger before = run->ledger();
  run->advance(std::llround(end / step));
  EXPECT_GT(run->ledger().dissipated_tangential, 0.01 * before.kinetic);
  return std::abs(run->ledger().balance() - before.balance()) / before.kinetic;
}

// Some hundred contacts that begin, slide, grip and end: friction's work is booked from the kicks, so
// only how they follow the normal springs is left over.
TEST_P(TurningLedgerOf, BalanceDriftsWithTheIntegratorsOrder) {
  const bool first_order = name_of(GetParam()).starts_with("euler");
  const double coarse = drift(GetParam(), 5e-5, 0.05), fine = drift(GetParam(), 5e-6, 0.05);
  EXPECT_NEAR(std::log10(coarse / fine), first_order ? 1.0 : 2.0, 0.1);
  EXPECT_LE(fine, first_order ? 2e-3 : 1e-6);
}

std::string name_of_case(const ::testing::TestParamInfo<Integrator>& info) {
  return std::string(name_of(info.param));
}

INSTANTIATE_TEST_SUITE_P(Integrators, TurningLedgerOf,
                         ::testing::Values(Integrator::euler_trapezoid,
                                           Integrator::euler_trapezoid_implicit_drag,
                                           Integrator::leapfrog_verlet, Integrator::velocity_verlet,
                                           Integrator::velocity_verlet_predicted, Integrator::onset_corrected,
                                           Integrator::velocity_verlet_implicit),
                         name_of_case);

}  // namespace
}  // namespace grainproof::testing
