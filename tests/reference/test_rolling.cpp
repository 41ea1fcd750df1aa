// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/contact_force.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

using reference::ContactPoint;
using reference::ContactSprings;
using reference::PairLaws;

constexpr double torque_tolerance = 1e-15;  // torques of order 0.1 to 1, a few roundings

ContactLaws rolling_laws(const RollingLaw& rolling, TorqueArm arm = TorqueArm::radius) {
  ContactLaws laws = linear(1000.0, Damping{4.0});
  laws.friction = HistoryFriction{0.5, 500.0, 0.0, CoulombLimit::spring, arm};
  laws.rolling = rolling;
  return laws;
}

Scene rolling_scene(const ContactLaws& laws, double step) {
  Scene scene = empty_scene(laws, step);
  scene.rotation = true;
  return scene;
}

PairLaws resolved(const RollingLaw& rolling) {
  return reference::resolve(rolling_scene(rolling_laws(rolling), 1e-4), 0, 0);
}

/// Overlap 0.01, R* 0.1, approaching at 1 m/s: the spring pushes 10 N, the dashpot 4 N.
const ContactPoint point{Vec3::UnitX(), 0.01, -Vec3::UnitX(), 1.0, 0.1};
constexpr double normal_force = 14.0;

// 0.2 · 0.1 · 10 N, over |ω| 13 with its part along n: (0, −4, −12)/13.
TEST(ConstantTorqueRolling, IsThePushsTorqueAgainstTheWholeSpinLessWhatTwists) {
  ContactSprings springs;
  const Vec3 torque = rolling_torque(resolved(ConstantTorqueRolling{0.2}), point, {3.0, 4.0, 12.0},
                                     normal_force, 1e-4, springs);
  EXPECT_LE((torque - 0.2 / 13.0 * Vec3(0.0, -4.0, -12.0)).norm(), torque_tolerance);
  EXPECT_EQ(springs.rolling_torque, Vec3::Zero());
}

TEST(ConstantTorqueRolling, WithoutSpinThereIsNone) {
  ContactSprings springs;
  const PairLaws laws = resolved(ConstantTorqueRolling{0.2});
  EXPECT_EQ(rolling_torque(laws, point, Vec3::Zero(), normal_force, 1e-4, springs), Vec3::Zero());
}

// k_r = 500 · 0.1² = 5 N m/rad over 1e-3 s; what is kept stays as it is in space, its part along n too.
TEST(SpringRolling, WindsAgainstTheSpinAcrossTheNormal) {
  ContactSprings springs{.rolling_torque = {0.01, 0.1, 0.0}};
  const Vec3 torque =
      rolling_torque(resolved(SpringRolling{0.2}), point, {3.0, 4.0, 12.0}, normal_force, 1e-3, springs);
  EXPECT_LE((torque - Vec3(0.01, 0.1 - 0.02, -0.06)).norm(), torque_tolerance);
  EXPECT_EQ(springs.rolling_torque, torque);
}

// 0.2 · 0.1 · 14 N: the dashpot's part of the normal force counts.
TEST(SpringRolling, IsCutBackToItsLimit) {
  ContactSprings springs{.rolling_torque = {0.0, 3.0, 4.0}};
  const Vec3 torque =
      rolling_torque(resolved(SpringRolling{0.2}), point, Vec3::Zero(), normal_force, 1e-3, springs);
  EXPECT_LE((torque - 0.28 * Vec3(0.0, 0.6, 0.8)).norm(), torque_tolerance);
  EXPECT_EQ(springs.rolling_torque, torque);
}

// E* 0.8e9, G* 1.5e9/8.75 and a contact circle of 2e-3 as in the tests of Hertz contacts.
TEST(HertzRolling, TakesHertzPushAndMindlinsStiffnessOfTheMoment) {
  Scene scene = rolling_scene({}, 1e-5);
  scene.materials[0].elasticity = Elasticity{1.5e9, 0.25};
  ContactLaws laws{.normal = HertzNormal{Restitution{0.5}}, .friction = HistoryFriction{0.5, 0.0, 1.0}};
  const ContactPoint deep{Vec3::UnitX(), 1e-4, Vec3::Zero(), 0.01, 0.04};
  ContactSprings springs;
  laws.rolling = ConstantTorqueRolling{0.1};
  scene.contacts.set(0, 0, laws);
  const Vec3 constant =
      rolling_torque(reference::resolve(scene, 0, 0), deep, {0.0, 2.0, 0.0}, 1.0, 1e-5, springs);
  const double push = 4.0 / 3.0 * 0.8e9 * 2e-3 * 1e-4;
  EXPECT_NEAR(constant.y(), -0.1 * 0.04 * push, 1e-12);
  laws.rolling = SpringRolling{10.0};
  scene.contacts.set(0, 0, laws);
  const Vec3 wound =
      rolling_torque(reference::resolve(scene, 0, 0), deep, {0.0, 2.0, 0.0}, 1e4, 1e-5, springs);
  EXPECT_NEAR(wound.y(), -8.0 * (1.5e9 / 8.75) * 2e-3 * 0.04 * 0.04 * 2e-5, 1e-12);
}

/// Two spheres of radii 0.05 and 0.1 overlapping by 0.01 along x, at rest; the second spins about z.
Scene unequal_pair(const RollingLaw& rolling) {
  Scene scene = rolling_scene(rolling_laws(rolling), 1e-4);
  scene.contacts.set(0, 0, {.normal = LinearNormal{1000.0, Damping{0.0}}, .rolling = rolling});
  scene.run.integrator = Integrator::euler_trapezoid;
  add_particle(scene, 0.1, Vec3::Zero());
  add_particle(scene, 0.2, {0.14, 0.0, 0.0}).angular_velocity = {0.0, 0.0, 6.0};
  return scene;
}

Vec3 torque_on(const Scene& scene, std::size_t particle) {
  const double d = scene.particles[particle].diameter;
  const Vec3 before = scene.particles[particle].angular_velocity;
  const Vec3 after = frame_after(scene, 1).angular_velocity[particle];
  return 0.1 * sphere_mass(d) * d * d * (after - before) / scene.run.step;
}

// R* = 0.05 · 0.1/0.15; 10 N; 0.3 of that. One rounding of ω over a step of 1e-4.
TEST(Rolling, ActsOnBothOfAPairOppositely) {
  const double expected = 0.3 * (0.05 * 0.1 / 0.15) * 10.0;
  const Scene scene = unequal_pair(ConstantTorqueRolling{0.3});
  EXPECT_LE((torque_on(scene, 0) - Vec3(0.0, 0.0, expected)).norm(), 1e-12);
  EXPECT_LE((torque_on(scene, 1) + Vec3(0.0, 0.0, expected)).norm(), 1e-12);
}

TEST(Rolling, AtAWallTheEffectiveRadiusIsTheParticlesAndTheWallsTurnCounts) {
  Scene scene = unequal_pair(ConstantTorqueRolling{0.3});
  scene.particles.resize(1);
  scene.particles[0].position = {0.0, 0.0, 0.04};
  scene.particles[0].angular_velocity = {2.0, 0.0, 0.0};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  EXPECT_LE((torque_on(scene, 0) - Vec3(-0.3 * 0.05 * 10.0, 0.0, 0.0)).norm(), 1e-12);
  scene.walls[0].shape = Cylinder{{0.0, 0.0, 1.0}, Vec3::UnitX(), 1.0, Cylinder::Side::inside};
  scene.walls[0].motion = Rotating{5.0};
  EXPECT_LE((torque_on(scene, 0) - Vec3(0.3 * 0.05 * 10.0, 0.0, 0.0)).norm(), 1e-12);
}

/// Rolls along x at 1 m/s on a floor in which it rests.
Scene roller(const RollingLaw& rolling, double stiffness) {
  ContactLaws laws = linear(stiffness, Restitution{0.5});
  laws.friction = HistoryFriction{0.5, 0.8 * stiffness, 1.0};
  laws.rolling = rolling;
  Scene scene = rolling_scene(laws, 2e-5);
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, 0.1, {0.0, 0.0, 0.05 - sphere_mass(0.1) * 9.81 / stiffness}, {1.0, 0.0, 0.0})
      .angular_velocity = {0.0, 20.0, 0.0};
  return scene;
}

// 7/5 m u' = −μ_r m g. The friction spring starts from zero and swings about its force of 2/7 μ_r m g,
// dashed: its displacement of 1e-7 m is the path that is missing, some 1e-6 m/s of its vibration is left.
TEST(Rolling, SlowsARollingSphereByFiveSeventhsOfItsCoefficientTimesGravity) {
  const double expected = 1.0 - 5.0 / 7.0 * 0.02 * 9.81 * 0.5;
  EXPECT_NEAR(frame_after(roller(ConstantTorqueRolling{0.02}, 1e6), 25000).velocity[0].x(), expected, 1e-5);
}

// Its spring is wound up to μ_r m g r over an angle of 1e-6 rad first.
TEST(Rolling, WoundUpSpringSlowsJustTheSame) {
  const double expected = 1.0 - 5.0 / 7.0 * 0.02 * 9.81 * 0.5;
  EXPECT_NEAR(frame_after(roller(SpringRolling{0.02}, 1e6), 25000).velocity[0].x(), expected, 1e-5);
}

TEST(Rolling, StateNamesTheSpringsTorqueAsItActsOnTheFirst) {
  Scene scene = roller(SpringRolling{0.02}, 1e6);
  const auto run = start(scene);
  EXPECT_EQ(run->state().contacts.at(0).rolling_torque, Vec3::Zero());
  run->advance(500);
  const double most = 0.02 * 0.05 * sphere_mass(0.1) * 9.81;
  EXPECT_NEAR(run->state().contacts.at(0).rolling_torque.y(), -most, 1e-6 * most);
  scene = unequal_pair(SpringRolling{0.3});
  scene.contacts.set(0, 0, rolling_laws(SpringRolling{0.3}));
  scene.particles[0].fixed = true;
  const auto pair = start(scene);
  pair->advance(1);
  EXPECT_GT(pair->state().contacts.at(0).rolling_torque.z(), 1e-6);
}

/// Torque of a spring wound in one step by a sphere 0.01 deep in a floor.
double wound_at_wall(TorqueArm arm) {
  Scene scene = rolling_scene(rolling_laws(SpringRolling{10.0}, arm), 1e-7);
  scene.run.integrator = Integrator::euler_trapezoid;
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, 0.1, {0.0, 0.0, 0.04}).angular_velocity = {0.0, 0.0, 0.0};
  scene.particles[0].angular_velocity = {2.0, 0.0, 0.0};
  const auto run = start(scene);
  run->advance(1);
  return run->state().contacts.at(0).rolling_torque.x() / (-500.0 * 0.05 * 0.05 * 2.0 * 1e-7);
}

// As measured of LIGGGHTS: the speed at its arm of r − δ/2 over the distance r − δ.
TEST(SpringRolling, WithTheShorterArmAWallsSpinIsReckonedAtTheDistance) {
  EXPECT_NEAR(wound_at_wall(TorqueArm::radius), 1.0, 1e-5);
  EXPECT_NEAR(wound_at_wall(TorqueArm::overlap), 0.045 / 0.04, 1e-5);
}

}  // namespace
}  // namespace grainproof::testing
