// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "comparisons/lammps/engine.hpp"
#include "comparisons/liggghts/engine.hpp"
#include "tests/comparisons/one_dimension.hpp"

/// Walls that are no still planes, where a body meets them as it would meet a plane: head-on.
namespace grainproof::test {
namespace {

/// A sphere of 0.1 m that flies at −x from the surface of a wall at x = 0.05.
Scene against(WallShape shape, WallMotion motion = Still{}) {
  Scene scene = collision_with_fixed(32.6, 0.3);
  scene.domain = {Vec3::Constant(-1.0), Vec3::Constant(1.0)};
  scene.particles.erase(scene.particles.begin());
  scene.walls = {{"wall", 0, shape, motion}};
  return scene;
}

void expect_plain_rebound(Engine& engine, const Scene& scene) {
  const Support support = engine.supports(scene, {});
  ASSERT_TRUE(support.yes) << support.because;
  const Observations seen = engine.observe(scene, {});
  ASSERT_EQ(seen.outcome.status, Outcome::Status::completed) << seen.outcome.reason;
  EXPECT_NEAR(seen.frames.back().velocity[0].x() / bounced(scene).v, 1.0, 1e-9);
}

Cylinder hole(int axis) {
  Vec3 point = Vec3::Zero();
  point.x() = 0.05 + 0.4;
  return {point, Vec3::Unit(axis), 0.4, Cylinder::Side::inside};
}

TEST(PeerWalls, LiggghtsCylindersAreThoseOfTheSceneFromEitherSideAndOffTheOrigin) {
  LiggghtsEngine liggghts;
  for (const int axis : {1, 2}) {
    expect_plain_rebound(liggghts, against(hole(axis)));
    Cylinder pole = hole(axis);
    pole.point = Vec3(0.05 - 0.3, 0.0, 0.0);
    pole.radius = 0.3;
    pole.side = Cylinder::Side::outside;
    expect_plain_rebound(liggghts, against(pole));
  }
}

TEST(PeerWalls, LiggghtsRectanglesOfTwoTrianglesAreOneFlatWallWithinTheirEdges) {
  LiggghtsEngine liggghts;
  const Rectangle flat{Vec3(0.05, -0.3, -0.2), Vec3(0.05, 0.3, 0.2)};
  expect_plain_rebound(liggghts, against(flat));  // at the diagonal that both triangles share
  Scene past = against(flat);
  past.particles[0].position.y() = 0.36;  // beyond the edge
  EXPECT_EQ(liggghts.observe(past, {}).frames.back().velocity[0], past.particles[0].velocity);
}

TEST(PeerWalls, LammpsTurningCylinderPushesOnlyAlongItsSurface) {
  LammpsEngine lammps;
  for (const int axis : {1, 2}) {
    Scene scene = against(hole(axis), Rotating{3.0});
    expect_plain_rebound(lammps, scene);
    scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{restitution_value}}, DynamicFriction{0.1}});
    const Observations seen = lammps.observe(scene, {});
    EXPECT_NEAR(seen.frames.back().velocity[0].x() / bounced(scene).v, 1.0, 1e-3);
    const Vec3 along = 3.0 * Vec3::Unit(axis).cross(-Vec3::UnitX());  // of the surface at −x from the axis
    EXPECT_GT(seen.frames.back().velocity[0].dot(along.normalized()), 0.1);
  }
}

TEST(PeerWalls, WhatOnlyOneProgramHasTheOtherRefusesWithTheReason) {
  const LammpsEngine lammps;
  const LiggghtsEngine liggghts;
  const auto because = [](const Engine& engine, const Scene& scene) {
    return engine.supports(scene, {}).because;
  };
  EXPECT_NE(because(liggghts, against(hole(2), Rotating{3.0})).find("sphere's centre"), std::string::npos);
  EXPECT_NE(because(lammps, against(hole(2))).find("about the z axis"), std::string::npos);
  EXPECT_NE(
      because(lammps, against(Rectangle{Vec3(0.05, -0.3, -0.2), Vec3(0.05, 0.3, 0.2)})).find("no edges"),
      std::string::npos);
  const Plane side{Vec3(0.05, 0.0, 0.0), Vec3::UnitX()};
  EXPECT_EQ(because(lammps, against(side, Translating{Vec3(0.0, 1.0, 0.0)})), "");
  EXPECT_EQ(because(liggghts, against(side, Translating{Vec3(0.0, 1.0, 0.0)})), "");
  EXPECT_NE(because(lammps, against(side, Translating{Vec3(1.0, 0.0, 0.0)})).find("within themselves"),
            std::string::npos);
  EXPECT_NE(because(liggghts, against(side, Translating{Vec3(1.0, 0.0, 0.0)})).find("within themselves"),
            std::string::npos);
  EXPECT_NE(because(lammps, against(side, Vibrating{Vec3(0.01, 0, 0), 10.0, 0.0})).find("from rest"),
            std::string::npos);
}

}  // namespace
}  // namespace grainproof::test
