// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double diameter = 0.1, stiffness = 1e5, restitution = 0.8, gravity = 9.81;

double contact_time() {
  const double log = std::log(restitution), mass = sphere_mass(diameter);
  const double eta =
      -2.0 * log * std::sqrt(mass * stiffness / (std::numbers::pi * std::numbers::pi + log * log));
  return std::numbers::pi / std::sqrt(stiffness / mass - eta * eta / (4.0 * mass * mass));
}

Scene settling(double step) {
  Scene scene = empty_scene(linear(stiffness, Restitution{restitution}), step);
  scene.gravity = ConstantGravity{{0.0, 0.0, -gravity}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_particle(scene, diameter, {0.0, 0.0, 0.5 * diameter});
  return scene;
}

// The position 0.05 has a last digit of 7e-18 m and the overlap is 1e-4 m: nothing below 7e-14 can be seen.
TEST(Settling, OverlapIsWeightOverStiffness) {
  const Scene scene = settling(contact_time() / 64.0);
  const Frame frame = frame_after(scene, 64 * 1000);
  const double overlap = 0.5 * diameter - frame.position[0].z();
  const double expected = sphere_mass(diameter) * gravity / stiffness;
  EXPECT_LE(std::abs(overlap / expected - 1.0), 1e-12);
  EXPECT_LE(frame.velocity[0].norm(), 1e-12);
}

}  // namespace
}  // namespace grainproof::testing
