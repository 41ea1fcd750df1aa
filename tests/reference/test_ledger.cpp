// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// 64 particles, two of them fixed, poured into a closed box against a stream, with every law on.
Scene busy_scene(Integrator integrator) {
  ContactLaws laws = linear(1e4, Restitution{0.7});
  laws.friction = DampedFriction{0.4, 3e3};
  laws.cohesion = LinearCohesion{20.0};
  Scene scene = empty_scene(laws, 5e-5);
  scene.run.integrator = integrator;
  scene.domain = {.lower = Vec3::Zero(), .upper = Vec3::Constant(0.6)};
  close_domain(scene);
  scene.gravity = ConstantGravity{{1.0, 0.0, -9.81}};
  scene.flow = TaylorGreenFlow{0.5, 2.0, 5.0};
  Random random(31);
  for (int i = 0; i < 64; ++i) {
    const Vec3 site = 0.15 * (Vec3(i % 4, i / 4 % 4, i / 16) + Vec3::Constant(0.5));
    add_particle(scene, 0.13, site, random.in_box(Vec3::Constant(-2.0), Vec3::Constant(2.0)))
        .effect_diameter = 0.135;
  }
  for (const int i : {7, 21}) {
    scene.particles[i].fixed = true;
    scene.particles[i].velocity.setZero();
  }
  return scene;
}

class LedgerOf : public ::testing::TestWithParam<Integrator> {};

// The same kicks are summed twice in another order: round-off of 62 masses of 2.3 kg at some 3 m/s over
// 4000 steps, one last digit each, as a random walk.
TEST_P(LedgerOf, MomentumBalanceClosesToRoundOff) {
  const Scene scene = busy_scene(GetParam());
  const auto run = start(scene, true);
  const Vec3 before = momentum(scene, run->frame());
  run->advance(4000);
  const Ledger ledger = run->ledger();
  const Vec3 gained = momentum(scene, run->frame()) - before;
  const double scale = 62.0 * 2.3 * 3.0;
  EXPECT_LE((gained - ledger.support_impulse - ledger.field_impulse).norm(),
            0x1p-53 * scale * std::sqrt(4000.0));
  EXPECT_GT(ledger.support_impulse.norm(), 10.0);
  EXPECT_GT(ledger.field_impulse.norm(), 10.0);
}

TEST_P(LedgerOf, KeepingItChangesNoBit) {
  const auto with = start(busy_scene(GetParam()), true), without = start(busy_scene(GetParam()), false);
  with->advance(500);
  without->advance(500);
  EXPECT_EQ(with->digest(), without->digest());
  EXPECT_EQ(without->ledger().kinetic, 0.0);
}

/// Sphere sliding on a plane, always in touch, with spring, dashpot, friction, cohesion, drag and gravity.
double balance_error(Integrator integrator, int steps) {
  ContactLaws laws = linear(1e3, Damping{4.0});
  laws.friction = DampedFriction{0.3, 50.0};
  laws.cohesion = LinearCohesion{100.0};
  Scene scene = empty_scene(laws, 0.3 / steps);
  scene.run.integrator = integrator;
  scene.gravity = RotatingGravity{9.81, 2.0};
  scene.flow = UniformFlow{0.5, {1.0, 0.0, 0.0}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitY());
  add_particle(scene, 0.1, {0.0, 0.0485, 0.0}, {2.0, 0.0, 0.0}).effect_diameter = 0.12;
  const auto run = start(scene, true);
  const double before = run->ledger().balance();
  run->advance(steps);
  return std::abs(run->ledger().balance() - before);
}

double order_of(Integrator integrator) {
  return std::log2(balance_error(integrator, 2000) / balance_error(integrator, 4000));
}

TEST(Ledger, BalanceDriftsWithTheIntegratorsOrder) {
  EXPECT_NEAR(order_of(Integrator::euler_trapezoid), 1.0, 0.1);
  EXPECT_NEAR(order_of(Integrator::euler_trapezoid_implicit_drag), 1.0, 0.1);
  EXPECT_NEAR(order_of(Integrator::velocity_verlet), 2.0, 0.1);
  EXPECT_NEAR(order_of(Integrator::leapfrog_verlet), 2.0, 0.1);
}

TEST(Ledger, FreeFallTradesHeightForSpeed) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 0.01);
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_particle(scene, 0.1, {0.0, 0.0, 5.0});
  const auto run = start(scene, true);
  run->advance(50);
  const double fallen = 5.0 - run->frame().position[0].z();
  const Ledger ledger = run->ledger();
  EXPECT_NEAR(ledger.gravity_work, sphere_mass(0.1) * 9.81 * fallen, 1e-13 * ledger.kinetic);
  EXPECT_NEAR(ledger.gravity_work, ledger.kinetic, 1e-13 * ledger.kinetic);
  EXPECT_NEAR(ledger.field_impulse.z(), -sphere_mass(0.1) * 9.81 * 0.5, 1e-14);
}

// 5000 steps a contact: the onset's error of the restitution is below 1e-4.
TEST(Ledger, CollisionDissipatesWhatRestitutionTakes) {
  Scene scene = empty_scene(linear(1e5, Restitution{0.8}), 1.4e-6);
  add_particle(scene, 0.1, {-0.06, 0.0, 0.0}, {1.0, 0.0, 0.0});
  add_particle(scene, 0.1, {0.06, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  const auto run = start(scene, true);
  run->advance(30000);
  const double kinetic = sphere_mass(0.1);
  EXPECT_NEAR(run->ledger().dissipated_normal, kinetic * (1.0 - 0.64), kinetic * 2e-4);
  EXPECT_EQ(run->ledger().elastic, 0.0);
  EXPECT_EQ(run->ledger().support_impulse, Vec3::Zero());
}

TEST(Ledger, SlidingDissipatesFrictionTimesPath) {
  ContactLaws laws = linear(1e5, Restitution{0.8});
  laws.friction = DynamicFriction{0.6};
  Scene scene = empty_scene(laws, 1e-4);
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  const double weight = sphere_mass(0.1) * 9.81;
  add_particle(scene, 0.1, {0.0, 0.0, 0.05 - weight / 1e5}, {1.0, 0.0, 0.0});
  const auto run = start(scene, true);
  run->advance(1000);
  const Frame frame = run->frame();
  EXPECT_NEAR(frame.velocity[0].x(), 1.0 - 0.6 * 9.81 * 0.1, 1e-12);
  EXPECT_NEAR(run->ledger().dissipated_tangential, 0.6 * weight * frame.position[0].x(), 1e-11);
  EXPECT_NEAR(run->ledger().wall_impulses.at(0).z(), weight * 0.1, 1e-12);
  EXPECT_NEAR(run->ledger().wall_impulses.at(0).x(), -0.6 * weight * 0.1, 1e-12);
}

TEST(Ledger, SupportIsWallsAndFixedParticlesTogether) {
  Scene scene = busy_scene(Integrator::velocity_verlet);
  for (Particle& particle : scene.particles) particle.fixed = false;
  const auto run = start(scene, true);
  run->advance(2000);
  Vec3 walls = Vec3::Zero();
  for (const Vec3& impulse : run->ledger().wall_impulses) walls += impulse;
  EXPECT_LE((walls - run->ledger().support_impulse).norm(), 1e-12 * walls.norm());
}

std::string name_of_case(const ::testing::TestParamInfo<Integrator>& info) {
  return std::string(name_of(info.param));
}

INSTANTIATE_TEST_SUITE_P(Integrators, LedgerOf,
                         ::testing::Values(Integrator::euler_trapezoid,
                                           Integrator::euler_trapezoid_implicit_drag,
                                           Integrator::leapfrog_verlet, Integrator::velocity_verlet,
                                           Integrator::velocity_verlet_predicted, Integrator::onset_corrected,
                                           Integrator::velocity_verlet_implicit),
                         name_of_case);

}  // namespace
}  // namespace grainproof::testing
