// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double radius = 0.05, diameter = 0.1;

double inertia(double d) {
  return 0.1 * sphere_mass(d) * d * d;
}

ContactLaws rubbing(const FrictionLaw& friction, Dissipation dissipation = Damping{0.0}) {
  ContactLaws laws = linear(1000.0, dissipation);
  laws.friction = friction;
  return laws;
}

Scene turning_scene(const ContactLaws& laws, double step) {
  Scene scene = empty_scene(laws, step);
  scene.rotation = true;
  return scene;
}

/// Torque on a particle in the state that the scene describes, from one explicit Euler step.
Vec3 torque_on(Scene scene, std::size_t particle) {
  scene.run.integrator = Integrator::euler_trapezoid;
  const Frame frame = frame_after(scene, 1);
  const Particle& before = scene.particles[particle];
  return inertia(before.diameter) * (frame.angular_velocity[particle] - before.angular_velocity) /
         scene.run.step;
}

/// A sphere 0.01 deep in a floor, sliding along x: normal force 10 N, friction 4 N.
Scene slider(const FrictionLaw& friction) {
  Scene scene = turning_scene(rubbing(friction), 1e-4);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, diameter, {0.0, 0.0, radius - 0.01}, {1.0, 0.0, 0.0});
  return scene;
}

constexpr HistoryFriction with_arm(TorqueArm arm) {
  return {0.4, 1000.0, 1e9, CoulombLimit::spring_and_dashpot, arm};
}

constexpr double torque_tolerance = 1e-13;  // torques of order 0.1; one rounding of ω over a step of 1e-4

// Friction at the bottom points back, so the sphere begins to roll forward: ω along +y.
TEST(Rotation, FloorTurnsASliderForward) {
  EXPECT_LE((torque_on(slider(DynamicFriction{0.4}), 0) - Vec3(0.0, 0.2, 0.0)).norm(), torque_tolerance);
  EXPECT_LE((force_on(slider(DynamicFriction{0.4}), 0) - Vec3(-4.0, 0.0, 10.0)).norm(), 1e-10);
}

Scene slider_with_dashpot(TorqueArm arm) {
  Scene scene = slider(with_arm(arm));
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.normal = LinearNormal{1000.0, Damping{1.0}};
  scene.contacts.set(0, 0, laws);
  return scene;
}

// The dashpot is so strong that friction is at its limit of 4 N at once. Arms: 0.05 and 0.05 − 0.01/2.
TEST(Rotation, TorqueArmIsRadiusOrShorterByHalfTheOverlap) {
  const Vec3 full = torque_on(slider_with_dashpot(TorqueArm::radius), 0);
  const Vec3 shorter = torque_on(slider_with_dashpot(TorqueArm::overlap), 0);
  EXPECT_LE((full - Vec3(0.0, 4.0 * 0.05, 0.0)).norm(), torque_tolerance);
  EXPECT_LE((shorter - Vec3(0.0, 4.0 * 0.045, 0.0)).norm(), torque_tolerance);
}

/// Unequal spheres overlapping by 0.01 along x; friction 4 N on the second along −y.
Scene unequal_pair() {
  Scene scene = turning_scene(rubbing(DynamicFriction{0.4}), 1e-4);
  add_particle(scene, 0.1, Vec3::Zero());
  add_particle(scene, 0.2, {0.14, 0.0, 0.0}, {0.0, 1.0, 0.0});
  return scene;
}

// (−a2 x) × (−4 y) = +4 a2 z, and (a1 x) × (4 y) = +4 a1 z.
TEST(Rotation, FrictionTurnsBothOfAPairTheSameWayEachByItsOwnArm) {
  EXPECT_LE((torque_on(unequal_pair(), 0) - Vec3(0.0, 0.0, 0.2)).norm(), torque_tolerance);
  EXPECT_LE((torque_on(unequal_pair(), 1) - Vec3(0.0, 0.0, 0.4)).norm(), 8 * torque_tolerance);
}

TEST(Rotation, GearsThatMeshDoNotRub) {
  Scene scene = unequal_pair();
  scene.particles[1].velocity.setZero();
  scene.particles[0].angular_velocity = {0.0, 0.0, 8.0};
  scene.particles[1].angular_velocity = {0.0, 0.0, -4.0};
  EXPECT_LE((force_on(scene, 1) - Vec3(10.0, 0.0, 0.0)).norm(), 1e-10);
  scene.particles[1].angular_velocity = {0.0, 0.0, 4.0};
  EXPECT_LE((force_on(scene, 1) - Vec3(10.0, 4.0, 0.0)).norm(), 1e-10);
}

TEST(Rotation, FixedParticleRubsAndDoesNotTurn) {
  Scene scene = unequal_pair();
  scene.particles[0].fixed = true;
  EXPECT_EQ(torque_on(scene, 0), Vec3::Zero());
  EXPECT_LE((torque_on(scene, 1) - Vec3(0.0, 0.0, 0.4)).norm(), 8 * torque_tolerance);
}

class SpinningUp : public ::testing::TestWithParam<Integrator> {};

// Constant friction μ m g at rest height for 0.05 s, before it rolls: ω = 5 μ g t/(2 r). 500 roundings.
TEST_P(SpinningUp, IsExactUnderConstantFriction) {
  Scene scene = turning_scene(rubbing(DynamicFriction{0.3}), 1e-4);
  scene.run.integrator = GetParam();
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, diameter, {0.0, 0.0, radius - sphere_mass(diameter) * 9.81 / 1000.0}, {1.0, 0.0, 0.0});
  const Frame frame = frame_after(scene, 500);
  const double expected = 2.5 * 0.3 * 9.81 * frame.time / radius;
  EXPECT_NEAR(frame.angular_velocity[0].y(), expected, 1e-12 * expected);
  EXPECT_NEAR(frame.velocity[0].x(), 1.0 - 0.3 * 9.81 * frame.time, 1e-12);
}

std::string name_of_case(const ::testing::TestParamInfo<Integrator>& info) {
  return std::string(name_of(info.param));
}

INSTANTIATE_TEST_SUITE_P(Integrators, SpinningUp,
                         ::testing::Values(Integrator::euler_trapezoid,
                                           Integrator::euler_trapezoid_implicit_drag,
                                           Integrator::leapfrog_verlet, Integrator::velocity_verlet,
                                           Integrator::velocity_verlet_predicted,
                                           Integrator::onset_corrected),
                         name_of_case);

struct Rolling {
  double begins;  ///< s
  double speed;   ///< m/s, once the spring is quiet
};

Rolling rolled(TorqueArm arm, double damping_ratio) {
  ContactLaws laws = linear(1e6, Restitution{0.3});
  laws.friction = HistoryFriction{0.3, 8e5, damping_ratio, CoulombLimit::spring_and_dashpot, arm};
  Scene scene = turning_scene(laws, 1e-5);
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, diameter, {0.0, 0.0, radius - sphere_mass(diameter) * 9.81 / 1e6}, {1.0, 0.0, 0.0});
  const auto run = start(scene);
  const double deep = sphere_mass(diameter) * 9.81 / 1e6;
  const double a = arm == TorqueArm::radius ? radius : radius - 0.5 * deep;
  const double without_slip = 1.0 / (1.0 + 0.4 * radius * radius / (a * a));
  while (run->frame().velocity[0].x() > without_slip) run->advance(1);
  const double begins = run->frame().time;
  run->advance(20000);
  return {begins, run->frame().velocity[0].x()};
}

// Sliding ends at 2 u0/(7 μ g). It begins late by the 4 µs in which the spring comes up to the limit,
// and its end is seen at the end of a step of 1e-5 s.
TEST(Rotation, SlidingEndsWhenSlipHasBeenUsedUp) {
  EXPECT_NEAR(rolled(TorqueArm::radius, 0.0).begins, 2.0 / (7.0 * 0.3 * 9.81), 1.5e-5);
}

// The overlap of 1e-5 m takes 1e-4 off the shorter arm, and 4/7 of half of that off the speed.
TEST(Rotation, RollingHasFiveSeventhsOfTheSpeed) {
  const double full = rolled(TorqueArm::radius, 1.0).speed, shorter = rolled(TorqueArm::overlap, 1.0).speed;
  EXPECT_NEAR(full, 5.0 / 7.0, 1e-9);
  const double a = 1.0 - 0.5 * sphere_mass(diameter) * 9.81 / 1e6 / radius;
  EXPECT_NEAR(shorter, 1.0 / (1.0 + 0.4 / (a * a)), 1e-9);
  EXPECT_LT(shorter, full - 1e-5);
}

/// About the origin.
Vec3 angular_momentum(const Scene& scene, const Frame& frame) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double d = scene.particles[i].diameter;
    sum +=
        sphere_mass(d) * frame.position[i].cross(frame.velocity[i]) + inertia(d) * frame.angular_velocity[i];
  }
  return sum;
}

Scene oblique_collision(TorqueArm arm, Integrator integrator) {
  ContactLaws laws = linear(1e5, Restitution{0.8});
  laws.friction = HistoryFriction{0.4, 8e4, 0.5, CoulombLimit::spring_and_dashpot, arm};
  Scene scene = turning_scene(laws, 2e-5);
  scene.run.integrator = integrator;
  add_particle(scene, 0.1, {-0.06, 0.3, 0.1}, {1.0, 0.4, 0.0}).angular_velocity = {5.0, -3.0, 8.0};
  add_particle(scene, 0.14, {0.065, 0.32, 0.11}, {-1.0, 0.0, 0.3}).angular_velocity = {0.0, 6.0, 2.0};
  return scene;
}

double momentum_change(TorqueArm arm, Integrator integrator) {
  const Scene scene = oblique_collision(arm, integrator);
  const auto run = start(scene);
  const Vec3 before = angular_momentum(scene, run->frame());
  const Vec3 spin_before = run->frame().angular_velocity[0];
  run->advance(1500);
  EXPECT_GT((run->frame().angular_velocity[0] - spin_before).norm(), 1.0);
  EXPECT_TRUE(run->state().contacts.empty());
  return (angular_momentum(scene, run->frame()) - before).norm() / before.norm();
}

// Each of 1500 steps rounds positions of 0.3 m by up to 3e-17, with 3 kg m/s at that arm.
TEST(Rotation, OnePointOfContactConservesAngularMomentum) {
  EXPECT_LE(momentum_change(TorqueArm::overlap, Integrator::velocity_verlet), 1e-13);
  EXPECT_LE(momentum_change(TorqueArm::overlap, Integrator::leapfrog_verlet), 1e-13);
}

// Arms of full length end beyond each other, so the pair of forces has a moment of the overlap times F_t.
TEST(Rotation, FullRadiusAsArmDoesNotConserveAngularMomentum) {
  const double change = momentum_change(TorqueArm::radius, Integrator::velocity_verlet);
  RecordProperty("change", std::to_string(change));
  EXPECT_GT(change, 1e-4);
  EXPECT_LT(change, 1e-2);
}

/// A collision without friction of bodies that turn `spin` times as fast as above.
Scene smooth_collision(double spin) {
  Scene scene = oblique_collision(TorqueArm::radius, Integrator::velocity_verlet);
  scene.contacts.set(0, 0, linear(1e5, Restitution{0.8}));
  for (Particle& particle : scene.particles) particle.angular_velocity *= spin;
  return scene;
}

TEST(Rotation, SmoothBodiesThatDoNotTurnMoveByTheSameBitsAsWithoutRotation) {
  Scene still = smooth_collision(0.0);
  const Frame b = frame_after(still, 1500);
  still.rotation = false;
  const Frame a = frame_after(still, 1500);
  EXPECT_TRUE(a.angular_velocity.empty());
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
}

// The slip of some 1 m/s leaves a rounding of its own in the normal velocity.
TEST(Rotation, SmoothBodiesGoOnTurningAsTheyDidAndItMovesNothing) {
  const Scene scene = smooth_collision(1.0);
  const Frame still = frame_after(smooth_collision(0.0), 1500), turning = frame_after(scene, 1500);
  for (const int i : {0, 1}) {
    EXPECT_EQ(turning.angular_velocity[i], scene.particles[i].angular_velocity);
    EXPECT_LE((turning.velocity[i] - still.velocity[i]).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace grainproof::testing
