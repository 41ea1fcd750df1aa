// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "input/sphere_grid.hpp"
#include "input/transforms.hpp"

namespace grainproof::input {
namespace {

/// Of the distance: positions are written in decimals, so surfaces meet to round-off only.
constexpr double touching = 1e-9;

double reach_of(const Particle& particle, Onset::Surface surface) {
  return 0.5 * (surface == Onset::Surface::body ? particle.diameter : particle.effect_diameter);
}

bool touch(double distance, double reach) {
  return std::abs(distance - reach) <= touching * reach;
}

bool touches_wall(const Scene& scene, const Particle& particle, Onset::Surface surface) {
  return std::any_of(scene.walls.begin(), scene.walls.end(), [&](const Wall& wall) {
    return touch(distance_to(wall.shape, particle.position), reach_of(particle, surface));
  });
}

bool any_pair_touches(const Scene& scene, Onset::Surface surface) {
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, reach_of(particle, surface));
  SphereGrid grid(scene.domain, 2.0 * (1.0 + touching) * largest, scene.particles.size());
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& one = scene.particles[i];
    const bool touched = grid.any_near(one.position, [&](std::size_t j) {
      const Particle& other = scene.particles[j];
      const double distance = nearest_image(scene.domain, one.position, other.position).norm();
      return touch(distance, reach_of(one, surface) + reach_of(other, surface));
    });
    if (touched) return true;
    grid.insert(i, one.position);
  }
  return false;
}

/// Of the smaller radius: as for a start without a sweep.
constexpr double deepest_start = 0.5;

bool too_deep(const Scene& scene, const Particle& one, const Particle& other) {
  const double distance = nearest_image(scene.domain, one.position, other.position).norm();
  const double overlap = 0.5 * (one.diameter + other.diameter) - distance;
  return overlap > (deepest_start + touching) * 0.5 * std::min(one.diameter, other.diameter) &&
         !(one.fixed && other.fixed);
}

bool in_a_wall(const Scene& scene, const Particle& particle) {
  const double radius = 0.5 * particle.diameter;
  return !particle.fixed && std::any_of(scene.walls.begin(), scene.walls.end(), [&](const Wall& wall) {
    return !(distance_to(wall.shape, particle.position) >= (1.0 - deepest_start - touching) * radius);
  });
}

}  // namespace

void check_still_apart(const Scene& scene, const Node& place) {
  const std::string once = " once " + std::string(place.name()) + " is applied";
  if (!(scene.domain.lower.array() < scene.domain.upper.array()).all() || !scene.domain.extent().allFinite())
    place.refuse("a domain without room" + once, "a transform that its numbers have digits for");
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
  if (scene.particles.empty()) return;
  SphereGrid grid(scene.domain, largest, scene.particles.size());
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& one = scene.particles[i];
    const auto deep_in = [&](std::size_t j) { return too_deep(scene, one, scene.particles[j]); };
    if (in_a_wall(scene, one) || grid.any_near(one.position, deep_in))
      place.refuse("particle " + std::to_string(one.id) + " deep in another or in a wall" + once,
                   "an overlap up to half the smaller radius");
    grid.insert(i, one.position);
  }
}

void check_touching(const Scene& scene, const Onset& onset) {
  for (const Particle& particle : scene.particles)
    if (!particle.fixed && touches_wall(scene, particle, onset.at)) return;
  if (!scene.particles.empty() && any_pair_touches(scene, onset.at)) return;
  onset.place.refuse("onset in a scene where no surfaces touch at the start",
                     std::string(onset.at == Onset::Surface::body ? "body" : "effect") +
                         " surfaces that touch, to 1e-9 of their distance");
}

}  // namespace grainproof::input
