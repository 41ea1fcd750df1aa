// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

// E15: the damped contact of the settling case under euler_trapezoid is stable below 2 η/k only.
double largest_swing(double share_of_limit) {
  const double stiffness = 1e5, mass = sphere_mass(0.1), log = std::log(0.8);
  const double eta =
      -2.0 * log * std::sqrt(mass * stiffness / (std::numbers::pi * std::numbers::pi + log * log));
  Scene scene = empty_scene(linear(stiffness, Restitution{0.8}), share_of_limit * 2.0 * eta / stiffness);
  scene.run.integrator = Integrator::euler_trapezoid;
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  const double rest = 0.05 - mass * 9.81 / stiffness;
  add_particle(scene, 0.1, {0.0, 0.0, rest + 1e-7});
  const auto run = start(scene);
  run->advance(99000);
  double swing = 0.0;
  for (int n = 0; n < 1000; ++n) {
    run->advance(1);
    swing = std::max(swing, std::abs(run->frame().position[0].z() - rest));
  }
  return swing;
}

// Both start 1e-7 m from rest; the contact is kept as long as the swing is below the overlap of 1.03e-4 m.
TEST(Stability, SettlingStaysBoundedJustBelowTwiceDampingOverStiffness) {
  EXPECT_LE(largest_swing(0.99), 1e-7);
}

TEST(Stability, SettlingGrowsJustAboveTwiceDampingOverStiffness) {
  EXPECT_GE(largest_swing(1.01), 5e-5);
}

}  // namespace
}  // namespace grainproof::testing
