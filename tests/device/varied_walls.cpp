// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "varied_walls.hpp"

#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

/// Index of the floor among the planes of a box.
constexpr std::size_t floor_wall = 4;

}  // namespace

Scene in_a_drum(Scene scene) {
  const Vec3 middle = (scene.domain.lower + scene.domain.upper) / 2, between = middle + Vec3(0.07, 0.07, 0);
  const HistoryFriction friction{0.5, 8e4, 1.0, CoulombLimit::spring, TorqueArm::overlap};
  scene.contacts.set(
      0, 0, {LinearNormal{stiffness, DampingRatio{0.1}}, friction, NoCohesion{}, SpringRolling{0.3}});
  scene.walls.push_back(
      {"drum", 0, Cylinder{middle, Vec3::UnitZ(), 0.258, Cylinder::Side::inside}, Rotating{12.0}});
  scene.walls.push_back({"pin", 0, Cylinder{between, Vec3::UnitZ(), 0.03, Cylinder::Side::outside},
                         Translating{{0.5, -0.4, 0.1}}});
  scene.walls[floor_wall].motion = Vibrating{{0, 0, 2e-3}, 120.0, 0.7};
  scene.orientation = OrientationUpdate::exponential;
  return scene;
}

Scene swept_by_a_paddle(Scene scene) {
  const HistoryFriction keeping{
      0.4, 0.0, 0.5, CoulombLimit::spring, TorqueArm::radius, SpringTurn::project, SpringMemory::force};
  scene.materials[0].elasticity = Elasticity{2e6, 0.3};
  scene.contacts.set(0, 0, {HertzNormal{DampingRatio{0.1}}, keeping, NoCohesion{}, SpringRolling{0.2}});
  const Vec3 lower = scene.domain.lower;
  scene.walls = {{"paddle", 0, Rectangle{lower + Vec3(0.003, 0.1, 0.02), lower + Vec3(0.003, 0.3, 0.25)},
                  Translating{{-1.5, 0.5, 0}}}};
  scene.orientation = OrientationUpdate::forward_euler;
  return scene;
}

Scene rolling_steadily(Scene scene) {
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Restitution{0.8}}, DampedFriction{0.5, 1e5},
                      LinearCohesion{1e3}, ConstantTorqueRolling{0.2}});
  scene.walls[floor_wall].motion = Rotating{15.0};
  return scene;
}

}  // namespace grainproof::opencl::testing
