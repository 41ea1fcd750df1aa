// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// Two spheres that touch softly, in a box of 16 m whose corner is at `corner`. All numbers are exact in
/// double.
Scene soft_touch(const Vec3& corner, Boundary boundary) {
  Scene scene = empty_scene(linear(1e5, Restitution{0.8}), 0x1p-16);
  scene.domain = {corner, corner + Vec3::Constant(16.0), {boundary, boundary, boundary}};
  add_particle(scene, 0.125, corner + Vec3(8.0, 8.0, 0.0), Vec3(0x1p-10, 0.0, -0x1p-10));
  add_particle(scene, 0.125, corner + Vec3(8.125, 8.0, 0.0), Vec3(-0x1p-10, 0.0, -0x1p-10));
  return scene;
}

Frame met(const Scene& scene) {
  return frame_after(scene, 1024);
}

TEST(FarAway, ASoftTouchIsTheSameToTheBit) {
  const Vec3 far(0x1p20, -0x1p20, 0x1p17);
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    Scene near = soft_touch(Vec3(16.0, 16.0, 16.0), boundary), there = soft_touch(far, boundary);
    if (boundary == Boundary::wall)
      for (Scene* scene : {&near, &there}) {
        for (Particle& particle : scene->particles) particle.position.z() += 0.0625;
        close_domain(*scene);
      }
    const Frame here = met(near), away = met(there);
    EXPECT_LT(here.velocity[0].x(), 0.0) << "they have parted";
    EXPECT_EQ(away.velocity, here.velocity);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_LT(((away.position[i] - far) - (here.position[i] - near.domain.lower)).norm(), 0x1p-31);
  }
}

// Below the origin of coordinates too, and never on the upper face that is the lower one.
TEST(FarAway, NoPlaceIsRoundedOntoTheUpperPeriodicFace) {
  const Vec3 far(-0x1p40, 0x1p40, 0x1p40);
  Scene scene = soft_touch(far, Boundary::periodic);
  scene.particles.pop_back();
  const Frame moved = frame_after(scene, 1);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE(moved.position[0][axis], scene.domain.lower[axis]);
    EXPECT_LT(moved.position[0][axis], scene.domain.upper[axis]);
  }
}

}  // namespace
}  // namespace grainproof::testing
