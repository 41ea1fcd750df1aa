// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// Sphere of diameter 0.2 resting on a floor that lifts it at a constant speed.
Scene lift() {
  Scene scene = empty_scene(linear(1e5, Restitution{0.5}), 1e-4);
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  const Vec3 speed(0.0, 0.0, 0.7);
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}, Translating{speed}});
  add_particle(scene, 0.2, {0.3, 0.2, 0.1 - sphere_mass(0.2) * 9.81 / 1e5}, speed);
  return scene;
}

// 5000 steps; the overlap of 8e-4 m rounds by 6e-17 m, so the force of 82 N by 6e-12 N.
TEST(LedgerOfWalls, LiftDoesTheWorkOfTheWeight) {
  const auto run = start(lift(), true);
  run->advance(5000);
  const double impulse = sphere_mass(0.2) * 9.81 * 0.5;
  const Ledger ledger = run->ledger();
  EXPECT_NEAR(ledger.wall_work, 0.7 * impulse, 1e-11 * impulse);
  EXPECT_NEAR(ledger.wall_work, -ledger.gravity_work, 1e-11 * impulse);
  ASSERT_EQ(ledger.wall_impulses.size(), 1u);
  EXPECT_LE((ledger.wall_impulses[0] - Vec3(0.0, 0.0, impulse)).norm(), 1e-11 * impulse);
}

// (0.3, 0.2, 0) × (0, 0, J), about a point that goes along.
TEST(LedgerOfWalls, AngularImpulseIsTakenAboutTheReferencePoint) {
  Scene scene = lift();
  const auto run = start(scene, true);
  run->advance(5000);
  const double impulse = sphere_mass(0.2) * 9.81 * 0.5;
  EXPECT_LE((run->ledger().wall_angular_impulses.at(0) - impulse * Vec3(0.2, -0.3, 0.0)).norm(),
            1e-11 * impulse);
}

// As above, on a tray that carries the sphere through the faces of a periodic domain five times: the arm is
// that to the image it lies on, (0.3, 0.4, 0) all the way.
TEST(LedgerOfWalls, AngularImpulseOfATrayIsTheSameBeyondAPeriodicFace) {
  Scene scene = lift();
  scene.domain = {.lower = {0.0, -1.0, -1.0}, .upper = {1.0, 1.0, 1.0}};
  scene.domain.boundary[0] = Boundary::periodic;
  const Vec3 speed(10.0, 0.0, 0.0);
  scene.walls = {{"tray", 0, Rectangle{{0.2, -0.3, 0.0}, {0.6, 0.4, 0.0}}, Translating{speed}}};
  scene.particles[0].position += Vec3(0.2, -0.1, 0.0);
  scene.particles[0].velocity = speed;
  const auto run = start(scene, true);
  run->advance(5000);
  const double impulse = sphere_mass(0.2) * 9.81 * 0.5;
  EXPECT_LE((run->ledger().wall_angular_impulses.at(0) - impulse * Vec3(0.4, -0.3, 0.0)).norm(),
            1e-11 * impulse);
}

ContactLaws everything() {
  return {.normal = HertzNormal{Restitution{0.7}},
          .friction = HistoryFriction{0.4, 0.0, 1.0},
          .cohesion = LinearCohesion{20.0},
          .rolling = SpringRolling{0.1}};
}

/// Turning, rolling, sticky, damped Hertz contacts in a box whose floor shakes and whose lid is a belt, round
/// a post that turns.
Scene shaken_box(Integrator integrator) {
  Scene scene = empty_scene({}, 5e-5);
  scene.materials[0].elasticity = Elasticity{1e7, 0.3};
  scene.contacts.set(0, 0, everything());
  scene.rotation = true;
  scene.run.integrator = integrator;
  scene.domain = {.lower = Vec3::Zero(), .upper = Vec3::Constant(0.6)};
  close_domain(scene);
  scene.walls[4].motion = Vibrating{{0.0, 0.0, 0.01}, 20.0, 0.3};
  scene.walls[5].motion = Translating{{1.0, 0.5, 0.0}};
  const Cylinder post{{0.3, 0.3, 0.0}, Vec3::UnitZ(), 0.04, Cylinder::Side::outside};
  scene.walls.push_back({"post", 0, post, Rotating{60.0}});
  scene.gravity = ConstantGravity{{1.0, 0.0, -9.81}};
  Random random(31);
  for (int i = 0; i < 64; ++i) {
    const Vec3 site = 0.15 * (Vec3(i % 4, i / 4 % 4, i / 16) + Vec3::Constant(0.5));
    add_particle(scene, 0.13, site, random.in_box(Vec3::Constant(-2.0), Vec3::Constant(2.0)))
        .angular_velocity = random.in_box(Vec3::Constant(-9.0), Vec3::Constant(9.0));
  }
  return scene;
}

class WallLedgerOf : public ::testing::TestWithParam<Integrator> {};

double drift(Integrator integrator, double step, double end) {
  Scene scene = shaken_box(integrator);
  scene.run.step = step;
  const auto run = start(scene, true);
  const Ledger before = run->ledger();
  run->advance(std::llround(end / step));
  const Ledger after = run->ledger();
  EXPECT_GT(std::abs(after.wall_work), 0.02 * before.kinetic);
  EXPECT_GT(after.dissipated_rolling, 1e-4 * before.kinetic);
  return std::abs(after.balance() - before.balance()) / before.kinetic;
}

TEST_P(WallLedgerOf, BalanceDriftsWithTheIntegratorsOrder) {
  const bool first_order = name_of(GetParam()).starts_with("euler");
  const double coarse = drift(GetParam(), 5e-5, 0.05), fine = drift(GetParam(), 5e-6, 0.05);
  EXPECT_NEAR(std::log10(coarse / fine), first_order ? 1.0 : 2.0, 0.1);
  EXPECT_LE(fine, first_order ? 2e-3 : 1e-6);
}

TEST_P(WallLedgerOf, KeepingItChangesNoBit) {
  const auto with = start(shaken_box(GetParam()), true), without = start(shaken_box(GetParam()), false);
  with->advance(500);
  without->advance(500);
  EXPECT_GT(with->state().contacts.size(), 10u);
  EXPECT_EQ(with->digest(), without->digest());
  EXPECT_TRUE(without->ledger().wall_impulses.empty());
}

// The only wall that does work turns about z: its work is its rate times what it gives about its axis. Sums
// of some 1 J in other orders over 2000 steps.
TEST_P(WallLedgerOf, TurningWallWorksByItsRateTimesItsAngularImpulse) {
  Scene scene = shaken_box(GetParam());
  scene.walls[4].motion = Still{};
  scene.walls[5].motion = Still{};
  const auto run = start(scene, true);
  run->advance(2000);
  const Ledger ledger = run->ledger();
  const double about_axis = ledger.wall_angular_impulses.at(6).z();
  EXPECT_GT(std::abs(about_axis), 1e-2);
  EXPECT_NEAR(ledger.wall_work, 60.0 * about_axis, 1e-12);
}

// Half a last digit of 2 m/s, 2000 times for each of 64 masses of 2.3 kg; in free fall always the same way.
TEST_P(WallLedgerOf, ImpulsesOfAllWallsAndFieldsAreTheMomentumGained) {
  const Scene scene = shaken_box(GetParam());
  const auto run = start(scene, true);
  const Vec3 before = momentum(scene, run->frame());
  run->advance(2000);
  const Ledger ledger = run->ledger();
  Vec3 impulse = ledger.field_impulse;
  for (const Vec3& wall : ledger.wall_impulses) impulse += wall;
  EXPECT_LE((momentum(scene, run->frame()) - before - impulse).norm(), 64.0 * 2.3 * 0x1p-52 * 2000.0);
  EXPECT_GT(impulse.norm(), 10.0);
}

std::string name_of_case(const ::testing::TestParamInfo<Integrator>& info) {
  return std::string(name_of(info.param));
}

INSTANTIATE_TEST_SUITE_P(Integrators, WallLedgerOf,
                         ::testing::Values(Integrator::euler_trapezoid,
                                           Integrator::euler_trapezoid_implicit_drag,
                                           Integrator::leapfrog_verlet, Integrator::velocity_verlet,
                                           Integrator::velocity_verlet_predicted, Integrator::onset_corrected,
                                           Integrator::velocity_verlet_implicit),
                         name_of_case);

/// Rocks about x in a floor without friction, on a rolling spring far below its limit: k_r = 8e4 · 0.05².
Scene rocker(Integrator integrator, double step) {
  ContactLaws laws = linear(1e5, Damping{0.0});
  laws.friction = HistoryFriction{0.0, 8e4, 0.0};
  laws.rolling = SpringRolling{1e9};
  Scene scene = empty_scene(laws, step);
  scene.run.integrator = integrator;
  scene.rotation = true;
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, 0.1, {0.0, 0.0, 0.05 - sphere_mass(0.1) * 9.81 / 1e5}).angular_velocity.x() = 1.0;
  return scene;
}

// A quarter of the period 2π sqrt(I/k_r): all energy is in the spring. Second order in the step.
TEST(LedgerOfRolling, SpringTakesUpTheEnergyOfTheSpinAndDissipatesNone) {
  const double inertia = 0.1 * sphere_mass(0.1) * 0.01, stiffness = 8e4 * 0.05 * 0.05;
  const double quarter = 0.5 * std::numbers::pi * std::sqrt(inertia / stiffness);
  for (const Integrator integrator : {Integrator::velocity_verlet, Integrator::leapfrog_verlet}) {
    const auto run = start(rocker(integrator, quarter / 1000.0), true);
    const double before = run->ledger().elastic;
    run->advance(1000);
    const Ledger ledger = run->ledger();
    EXPECT_NEAR(ledger.elastic - before, 0.5 * inertia, 1e-5 * inertia);
    EXPECT_NEAR(ledger.kinetic, 0.0, 1e-5 * inertia);
    EXPECT_NEAR(ledger.dissipated_rolling, 0.0, 1e-5 * inertia);
  }
}

// Rolls on at once, so all that is lost is the rolling torque's work: 7/10 m (u0² − u²) and no more than the
// first swing of the friction spring.
TEST(LedgerOfRolling, ConstantTorqueTakesWhatTheRollingLoses) {
  Scene scene = rocker(Integrator::velocity_verlet, 2e-5);
  ContactLaws laws = linear(1e6, Restitution{0.5});
  laws.friction = HistoryFriction{0.5, 8e5, 1.0};
  laws.rolling = ConstantTorqueRolling{0.02};
  scene.contacts.set(0, 0, laws);
  scene.particles[0].position.z() = 0.05 - sphere_mass(0.1) * 9.81 / 1e6;
  scene.particles[0].velocity.x() = 1.0;
  scene.particles[0].angular_velocity = {0.0, 20.0, 0.0};
  const auto run = start(scene, true);
  const double before = run->ledger().kinetic;
  run->advance(25000);
  const Ledger ledger = run->ledger();
  EXPECT_NEAR(ledger.dissipated_rolling, before - ledger.kinetic, 1e-6 * before);
  EXPECT_GT(ledger.dissipated_rolling, 0.1 * before);
}

}  // namespace
}  // namespace grainproof::testing
