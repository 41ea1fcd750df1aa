// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

Scene spinner(OrientationUpdate update, Integrator integrator) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1e-3);
  scene.run.integrator = integrator;
  scene.rotation = true;
  scene.orientation = update;
  add_particle(scene, 0.1, Vec3::Zero()).angular_velocity = {3.0, -4.0, 12.0};
  return scene;
}

double angle_between(const Quaternion& one, const Quaternion& other) {
  return 2.0 * (one.conjugate() * other).vec().norm();
}

class Orientation : public ::testing::TestWithParam<Integrator> {};

// 1000 products of unit quaternions, one rounding each.
TEST_P(Orientation, ConstantSpinTurnsByRateTimesTime) {
  const Frame frame = frame_after(spinner(OrientationUpdate::exponential, GetParam()), 1000);
  const Quaternion expected(Eigen::AngleAxisd(13.0 * 1.0, Vec3(3.0, -4.0, 12.0) / 13.0));
  ASSERT_EQ(frame.orientation.size(), 1u);
  EXPECT_LE(angle_between(frame.orientation[0], expected), 1e-12);
  EXPECT_NEAR(frame.orientation[0].norm(), 1.0, 1e-13);
}

// (1 + ω² Δt²/4) each step under the root, and atan(ω Δt/2) instead of ω Δt/2.
TEST_P(Orientation, PrintedEulerTurnsTooLittleAndGrows) {
  const Frame frame = frame_after(spinner(OrientationUpdate::forward_euler, GetParam()), 1000);
  const double half = 0.5 * 13.0 * 1e-3;
  const Quaternion expected(Eigen::AngleAxisd(2000.0 * std::atan(half), Vec3(3.0, -4.0, 12.0) / 13.0));
  EXPECT_NEAR(frame.orientation[0].norm(), std::pow(1.0 + half * half, 500.0), 1e-12);
  EXPECT_LE(angle_between(frame.orientation[0].normalized(), expected), 1e-12);
}

// Under constant friction μ m g, before it rolls, ω grows as 5 μ g t/(2 r): every integrator turns by just
// half of that times t, to the round-off of 500 steps.
TEST_P(Orientation, SpinningUpTurnsByHalfTheRateTimesTime) {
  Scene scene = spinner(OrientationUpdate::exponential, GetParam());
  ContactLaws laws = linear(1000.0, Damping{0.0});
  laws.friction = DynamicFriction{0.3};
  scene.contacts.set(0, 0, laws);
  scene.run.step = 1e-4;
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  Particle& particle = scene.particles[0];
  particle.angular_velocity.setZero();
  particle.velocity.x() = 1.0;
  particle.position.z() = 0.05 - sphere_mass(0.1) * 9.81 / 1000.0;
  const Frame frame = frame_after(scene, 500);
  const double angle = 0.5 * (2.5 * 0.3 * 9.81 / 0.05) * frame.time * frame.time;
  EXPECT_LE(angle_between(frame.orientation[0], Quaternion(Eigen::AngleAxisd(angle, Vec3::UnitY()))), 1e-12);
}

TEST_P(Orientation, IsKeptOnlyWhereAskedForAndMovesNothing) {
  const Frame without = frame_after(spinner(OrientationUpdate::none, GetParam()), 10);
  const Frame with = frame_after(spinner(OrientationUpdate::exponential, GetParam()), 10);
  EXPECT_TRUE(without.orientation.empty());
  EXPECT_EQ(with.angular_velocity, without.angular_velocity);
}

TEST_P(Orientation, StateAndDigestHoldIt) {
  const auto turned = start(spinner(OrientationUpdate::exponential, GetParam()));
  const auto stepped = start(spinner(OrientationUpdate::forward_euler, GetParam()));
  EXPECT_EQ(turned->state().orientation.at(0).coeffs(), Quaternion::Identity().coeffs());
  EXPECT_EQ(turned->digest(), stepped->digest());
  turned->advance(1);
  stepped->advance(1);
  EXPECT_NE(turned->digest(), stepped->digest());
}

std::string name_of_case(const ::testing::TestParamInfo<Integrator>& info) {
  return std::string(name_of(info.param));
}

INSTANTIATE_TEST_SUITE_P(Integrators, Orientation,
                         ::testing::Values(Integrator::euler_trapezoid,
                                           Integrator::euler_trapezoid_implicit_drag,
                                           Integrator::leapfrog_verlet, Integrator::velocity_verlet,
                                           Integrator::velocity_verlet_predicted,
                                           Integrator::onset_corrected),
                         name_of_case);

}  // namespace
}  // namespace grainproof::testing
