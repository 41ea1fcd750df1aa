// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/possible_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "analytic/contact_scales.hpp"
#include "analytic/hertz.hpp"

namespace grainproof::analytic {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Body {
  double mass = never;
  double radius = never;
  double drag = 0.0;
};

/// The lighter body; of two immovable ones the larger, whose Hertz contacts are the stiffer.
bool comes_first(const Body& one, const Body& other) {
  return std::isinf(one.mass) && std::isinf(other.mass) ? one.radius > other.radius : one.mass < other.mass;
}

/// The two lightest bodies of one material; a fixed one is infinitely heavy.
struct Lightest {
  std::optional<Body> first;
  std::optional<Body> second;

  void add(const Body& body) {
    if (!first || comes_first(body, *first)) {
      second = first;
      first = body;
    } else if (!second || comes_first(body, *second)) {
      second = body;
    }
  }
};

std::vector<Lightest> lightest_of_each(const Scene& scene) {
  std::vector<Lightest> lightest(scene.materials.size());
  for (const Particle& particle : scene.particles) {
    const double density = scene.materials[particle.material].density;
    const double radius = 0.5 * particle.diameter;
    const Body body = particle.fixed ? Body{never, radius}
                                     : Body{sphere_mass(density, particle.diameter), radius,
                                            drag_rate(scene.flow, density, particle.diameter)};
    lightest[particle.material].add(body);
  }
  return lightest;
}

/// Drag of an immovable partner says nothing.
PossibleContact contact_of(std::string between, const Body& one, const Body& other, const ContactLaws& laws,
                           std::pair<std::size_t, std::size_t> materials, bool on_wall) {
  const double one_drag = std::isinf(one.mass) ? other.drag : one.drag;
  const double other_drag = std::isinf(other.mass) ? one_drag : other.drag;
  return {std::move(between),
          effective_mass(one.mass, other.mass),
          effective_radius(one.radius, other.radius),
          &laws,
          materials,
          on_wall,
          std::min(one_drag, other_drag),
          std::max(one_drag, other_drag),
          {one.mass, other.mass},
          {2.0 * one.radius, 2.0 * other.radius}};
}

void add_pairs(const Scene& scene, const std::vector<Lightest>& lightest,
               std::vector<PossibleContact>& found) {
  for (std::size_t a = 0; a < lightest.size(); ++a)
    for (std::size_t b = a; b < lightest.size(); ++b) {
      const auto& one = lightest[a].first;
      const auto& other = a == b ? lightest[a].second : lightest[b].first;
      if (!one || !other || !scene.contacts.has(a, b)) continue;
      if (std::isinf(one->mass) && std::isinf(other->mass)) continue;
      found.push_back(contact_of(scene.materials[a].name + " and " + scene.materials[b].name, *one, *other,
                                 scene.contacts.at(a, b), {a, b}, false));
    }
}

void add_walls(const Scene& scene, const std::vector<Lightest>& lightest,
               std::vector<PossibleContact>& found) {
  for (const Wall& wall : scene.walls)
    for (std::size_t a = 0; a < lightest.size(); ++a) {
      const auto& body = lightest[a].first;
      if (!body || std::isinf(body->mass) || !scene.contacts.has(a, wall.material)) continue;
      found.push_back(contact_of(scene.materials[a].name + " and wall " + wall.name, *body, Body{},
                                 scene.contacts.at(a, wall.material), {a, wall.material}, true));
    }
}

}  // namespace

double drag_rate(const Flow& flow, double density, double diameter) {
  const double viscosity = std::visit(
      Overloaded{[](const NoFlow&) { return 0.0; }, [](const auto& stream) { return stream.viscosity; }},
      flow);
  return 18.0 * viscosity / (density * diameter * diameter);
}

std::vector<PossibleContact> possible_contacts(const Scene& scene) {
  const std::vector<Lightest> lightest = lightest_of_each(scene);
  std::vector<PossibleContact> found;
  add_pairs(scene, lightest, found);
  add_walls(scene, lightest, found);
  return found;
}

}  // namespace grainproof::analytic
