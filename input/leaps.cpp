// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <numbers>

#include "input/steps.hpp"
#include "input/text.hpp"
#include "model/strides.hpp"

namespace grainproof::input {
namespace {

constexpr const char* at_most_a_radius =
    "at most its radius, beyond which it may pass through what it should hit";

double largest_speed(const WallMotion& motion) {
  if (const auto* translating = std::get_if<Translating>(&motion)) return translating->velocity.stableNorm();
  const auto* vibrating = std::get_if<Vibrating>(&motion);
  return vibrating ? 2.0 * std::numbers::pi * vibrating->frequency * vibrating->amplitude.stableNorm() : 0.0;
}

double smallest_moving_radius(const Scene& scene) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Particle& particle : scene.particles)
    if (!particle.fixed) smallest = std::min(smallest, 0.5 * particle.diameter);
  return smallest;
}

}  // namespace

void check_strides(const Scene& scene, double step, const Node& place) {
  if (!may_leap(scene)) return;
  for (const Particle& particle : scene.particles) {
    const double radii = particle.velocity.stableNorm() * step / (0.5 * particle.diameter);
    if (!(radii <= 1.0))
      place.refuse(
          "particle " + std::to_string(particle.id) + " moving by " + shortest(radii) + " radii in a step",
          at_most_a_radius);
  }
  const double smallest = smallest_moving_radius(scene);
  for (const Wall& wall : scene.walls) {
    const double stride = largest_speed(wall.motion) * step;
    if (!std::holds_alternative<Plane>(wall.shape) && !(stride <= smallest))
      place.refuse("wall " + wall.name + " moving by " + shortest(stride) + " m in a step",
                   "at most the smallest radius of what it may hit, " + shortest(smallest) + " m");
  }
}

}  // namespace grainproof::input
