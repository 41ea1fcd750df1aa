// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// Frictional, cohesive gas in a periodic cube: nothing acts from outside.
Scene free_gas(Integrator integrator) {
  ContactLaws laws = linear(1e4, Restitution{0.7});
  laws.friction = DampedFriction{0.4, 3e3};
  laws.cohesion = LinearCohesion{20.0};
  Scene scene = empty_scene(laws, 5e-5);
  scene.run.integrator = integrator;
  scene.domain = {.lower = Vec3::Zero(), .upper = Vec3::Constant(0.7)};
  scene.domain.boundary.fill(Boundary::periodic);
  Random random(23);
  for (int i = 0; i < 125; ++i) {
    const Vec3 site = 0.14 * (Vec3(i % 5, i / 5 % 5, i / 25) + Vec3::Constant(0.5));
    add_particle(scene, random.between(0.07, 0.13), site,
                 random.in_box(Vec3::Constant(-2.0), Vec3::Constant(2.0)));
  }
  return scene;
}

class Conservation : public ::testing::TestWithParam<Integrator> {};

// Each contact force is added once with each sign, so what is left is the round-off of 125 velocities
// of order 1 m/s with masses of order 1 kg over 3000 steps, which adds up like a random walk.
TEST_P(Conservation, MomentumOfAFreeGasIsKeptToRoundOff) {
  const Scene scene = free_gas(GetParam());
  const auto run = start(scene);
  const Vec3 before = momentum(scene, run->frame());
  run->advance(3000);
  const Frame after = run->frame();
  EXPECT_LE((momentum(scene, after) - before).norm(), 0x1p-53 * std::sqrt(125.0 * 3000.0) * 10.0);
  double moved = 0.0;
  for (std::size_t i = 0; i < after.velocity.size(); ++i)
    moved += (after.velocity[i] - scene.particles[i].velocity).norm();
  EXPECT_GT(moved, 125.0 * 0.3);
}

TEST_P(Conservation, SameRunGivesTheSameBits) {
  const auto digest = [&] {
    const auto run = start(free_gas(GetParam()));
    run->advance(500);
    return run->digest();
  };
  EXPECT_EQ(digest(), digest());
}

std::string name_of_case(const ::testing::TestParamInfo<Integrator>& info) {
  return std::string(name_of(info.param));
}

INSTANTIATE_TEST_SUITE_P(Integrators, Conservation,
                         ::testing::Values(Integrator::euler_trapezoid,
                                           Integrator::euler_trapezoid_implicit_drag,
                                           Integrator::leapfrog_verlet, Integrator::velocity_verlet,
                                           Integrator::velocity_verlet_predicted, Integrator::onset_corrected,
                                           Integrator::velocity_verlet_implicit, Integrator::pefrl),
                         name_of_case);

TEST(Digest, ChangesWithTheLastBitOfAPosition) {
  Scene scene = free_gas(Integrator::velocity_verlet);
  const std::uint64_t before = start(scene)->digest();
  double& x = scene.particles[77].position.x();
  x = std::nextafter(x, 1.0);
  EXPECT_NE(start(scene)->digest(), before);
}

}  // namespace
}  // namespace grainproof::testing
