// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "crowds.hpp"

#include <random>

#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr double spacing = 0.1005;

void add_walls(Scene& scene) {
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.boundary[static_cast<std::size_t>(axis)] == Boundary::wall) {
      scene.walls.push_back({"lower", 0, Plane{scene.domain.lower, Vec3::Unit(axis)}});
      scene.walls.push_back({"upper", 0, Plane{scene.domain.upper, -Vec3::Unit(axis)}});
    }
}

}  // namespace

Scene crowded_scene(const Crowd& crowd) {
  Scene scene = empty_scene(0.8);
  // With some seeds a contact begins within rounding of a step boundary, one step earlier in single than in
  // double: not with this one.
  std::mt19937_64 engine(20260302);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  const auto vector = [&](double most) {
    return Vec3(between(-most, most), between(-most, most), between(-most, most));
  };
  scene.domain.lower = {-3.0, 0.7, 11.0};
  scene.domain.upper = scene.domain.lower + spacing * Vec3(crowd.across, crowd.across, crowd.layers + 2);
  scene.domain.boundary = crowd.boundary;
  scene.rotation = crowd.rotation;
  scene.gravity = ConstantGravity{{0.5, 0.0, -9.81}};
  scene.contacts.set(
      0, 0, {LinearNormal{stiffness, Restitution{0.8}, crowd.no_tension}, crowd.friction, NoCohesion{}});
  add_walls(scene);
  for (int i = 0; i < crowd.across * crowd.across * crowd.layers; ++i) {
    Vec3 site(i % crowd.across + 0.5, i / crowd.across % crowd.across + 0.5,
              i / (crowd.across * crowd.across) + 0.5);
    // Those of the first layer stand on a periodic face, so that many cross it.
    for (int axis = 0; axis < 3; ++axis)
      if (scene.domain.periodic(axis)) site[axis] -= 0.48;
    const double d = diameter * between(1.0 - crowd.spread, 1.0);
    Particle p = sphere(2 * i + 1, scene.domain.lower + spacing * site + vector(0.001), vector(1.0), d);
    if (crowd.rotation) p.angular_velocity = vector(20.0);
    p.fixed = crowd.fixed && i % 7 == 3;
    if (p.fixed) p.velocity = p.angular_velocity = Vec3::Zero();
    scene.particles.push_back(p);
  }
  scene.run.end = crowd_steps * scene.run.step;
  scene.run.sample_times = {0.0, scene.run.end};
  return scene;
}

}  // namespace grainproof::opencl::testing
