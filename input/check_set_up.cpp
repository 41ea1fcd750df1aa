// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <unordered_set>

#include "analytic/contact_scales.hpp"
#include "input/set_up.hpp"
#include "input/sphere_grid.hpp"
#include "input/text.hpp"

namespace grainproof::input {
namespace {

/// A deeper overlap at the start is a mistake: half the smaller radius.
constexpr double deepest_start = 0.5;

std::string named(const Particle& particle) {
  return "particle " + std::to_string(particle.id);
}

std::string percent(double fraction) {
  return shortest(std::round(1000.0 * fraction) / 10.0) + " %";
}

void check_ids(const SetUp& set_up) {
  std::unordered_set<std::int64_t> seen;
  for (const Group& group : set_up.groups) {
    const std::size_t end =
        &group == &set_up.groups.back() ? set_up.scene.particles.size() : (&group + 1)->first;
    for (std::size_t i = group.first; i < end; ++i) {
      const std::int64_t id = set_up.scene.particles[i].id;
      if (seen.insert(id).second) continue;
      const Node& place = group.ids.empty() ? place_of(set_up, i) : group.ids[i - group.first];
      place.refuse("id " + std::to_string(id) + " a second time", "a different id for every particle");
    }
  }
}

void check_inside(const SetUp& set_up) {
  const Domain& domain = set_up.scene.domain;
  for (std::size_t i = 0; i < set_up.scene.particles.size(); ++i) {
    const auto x = set_up.scene.particles[i].position.array();
    if ((x >= domain.lower.array()).all() && (x <= domain.upper.array()).all()) continue;
    place_of(set_up, i).refuse(named(set_up.scene.particles[i]) + " outside the domain",
                               "a position from domain.lower to domain.upper");
  }
}

void check_clear_of_walls(const SetUp& set_up) {
  for (std::size_t i = 0; i < set_up.scene.particles.size(); ++i) {
    const Particle& particle = set_up.scene.particles[i];
    const double radius = 0.5 * particle.diameter;
    for (const Wall& wall : set_up.scene.walls) {
      const double overlap = radius - distance_to(wall.shape, particle.position);
      if (overlap <= deepest_start * radius || particle.fixed) continue;
      place_of(set_up, i).refuse(
          named(particle) + " in wall " + wall.name + " by " + percent(overlap / radius) + " of its radius",
          "an overlap up to half the radius");
    }
  }
}

double largest_diameter(const Scene& scene) {
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
  return largest;
}

void check_pair(const SetUp& set_up, std::size_t i, std::size_t j) {
  const Particle& one = set_up.scene.particles[i];
  const Particle& other = set_up.scene.particles[j];
  const double apart = nearest_image(set_up.scene.domain, one.position, other.position).norm();
  const double smaller = 0.5 * std::min(one.diameter, other.diameter);
  const double overlap = 0.5 * (one.diameter + other.diameter) - apart;
  if (overlap <= deepest_start * smaller || (one.fixed && other.fixed)) return;
  place_of(set_up, i).refuse(
      named(one) + " in " + named(other) + " by " + percent(overlap / smaller) + " of the smaller radius",
      "an overlap up to half the smaller radius");
}

void check_overlaps(const SetUp& set_up) {
  const Scene& scene = set_up.scene;
  if (scene.particles.empty()) return;
  SphereGrid grid(scene.domain, largest_diameter(scene), scene.particles.size());
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    grid.any_near(scene.particles[i].position, [&](std::size_t j) {
      check_pair(set_up, i, j);
      return false;
    });
    grid.insert(i, scene.particles[i].position);
  }
}

/// A pair must not meet through two images at once.
void check_periodic(const SetUp& set_up, const Document& document) {
  const Scene& scene = set_up.scene;
  double reach = 0.0;
  for (const Particle& particle : scene.particles) reach = std::max(reach, particle.effect_diameter);
  for (int axis = 0; axis < 3; ++axis) {
    if (!scene.domain.periodic(axis) || scene.domain.extent()[axis] > 2.0 * reach) continue;
    root(document).at("domain").table().at("upper").refuse(
        "a periodic box " + shortest(scene.domain.extent()[axis]) + " m wide",
        "more than twice the largest particle, " + shortest(2.0 * reach) + " m");
  }
}

/// The harder a Hertz contact is hit, the shorter and the stiffer it is.
void check_impact_speed(const SetUp& set_up, const Document& document) {
  if (set_up.impact_speed || !analytic::lacks_impact_speed(set_up.scene)) return;
  root(document).at("run").refuse("no impact_speed, where nothing moves yet and Hertz contacts are possible",
                                  "impact_speed, which their duration and stiffness depend on");
}

}  // namespace

void check_set_up(const SetUp& set_up, const Document& document) {
  check_ids(set_up);
  check_periodic(set_up, document);
  check_inside(set_up);
  check_walls(set_up);
  check_clear_of_walls(set_up);
  check_overlaps(set_up);
  check_pairs_of_materials(set_up);
  check_impact_speed(set_up, document);
}

}  // namespace grainproof::input
