// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"

/// Small scenes that the tests of the closed forms start from.
namespace grainproof::analytic {

/// One material "glass" with itself: density 2000, k 1e5, restitution 0.8; no particles, no walls.
inline Scene glass_scene(LinearNormal normal = {1e5, Restitution{0.8}}) {
  Scene scene;
  scene.run = RunSettings{.end = 0.02, .step = 1e-4, .sample_times = {0.0, 0.01, 0.02}};
  scene.domain = {Vec3::Constant(-100.0), Vec3::Constant(100.0)};
  scene.materials = {{"glass", 2000.0, Elasticity{1e8, 0.25}}};
  scene.contacts = ContactTable(1);
  scene.contacts.set(0, 0, ContactLaws{normal});
  return scene;
}

inline void add_sphere(Scene& scene, const Vec3& position, const Vec3& velocity, bool fixed = false,
                       double diameter = 0.1) {
  const auto id = static_cast<std::int64_t>(scene.particles.size());
  scene.particles.push_back({id, 0, fixed, diameter, diameter, position, velocity});
}

inline void add_floor(Scene& scene) {
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}});
}

}  // namespace grainproof::analytic
