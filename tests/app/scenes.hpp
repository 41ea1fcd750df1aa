// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof::testing {

/// Unit spheres at these places in a box from (0, 0, 0) to (10, 10, 10).
inline Scene spheres_at(const std::vector<Vec3>& places, Boundary boundary = Boundary::open) {
  Scene scene;
  scene.run.end = 1.0;
  scene.run.step = 0.1;
  scene.domain = {Vec3::Zero(), Vec3::Constant(10.0), {boundary, boundary, boundary}};
  for (std::size_t i = 0; i < places.size(); ++i)
    scene.particles.push_back(
        {static_cast<std::int64_t>(10 * i + 7), 0, false, 1.0, 1.0, places[i], Vec3::Zero()});
  return scene;
}

inline Frame frame_of(const Scene& scene, std::int64_t step = 0) {
  Frame frame{step, static_cast<double>(step) * scene.run.step, {}, {}};
  for (const Particle& particle : scene.particles) {
    frame.position.push_back(particle.position);
    frame.velocity.push_back(particle.velocity);
  }
  return frame;
}

}  // namespace grainproof::testing
