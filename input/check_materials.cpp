// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"

namespace grainproof::input {
namespace {

/// How many particles there are of one material.
struct Census {
  std::size_t all = 0;
  std::size_t moving = 0;
};

std::vector<Census> census_of(const Scene& scene) {
  std::vector<Census> out(scene.materials.size());
  for (const Particle& particle : scene.particles) {
    ++out[particle.material].all;
    if (!particle.fixed) ++out[particle.material].moving;
  }
  return out;
}

const Node& place_of_material(const SetUp& set_up, std::size_t material) {
  for (const Group& group : set_up.groups)
    if (set_up.scene.particles[group.first].material == static_cast<std::int32_t>(material))
      return group.material;
  return set_up.groups.front().material;
}

void require(const SetUp& set_up, std::size_t a, std::size_t b) {
  if (set_up.scene.contacts.has(a, b)) return;
  const std::string pair =
      "\"" + set_up.scene.materials[a].name + "\", \"" + set_up.scene.materials[b].name + "\"";
  place_of_material(set_up, a).refuse("no contact for two materials that can meet",
                                      "[[contact]] between = [" + pair + "]");
}

}  // namespace

void check_pairs_of_materials(const SetUp& set_up) {
  const auto census = census_of(set_up.scene);
  for (std::size_t a = 0; a < census.size(); ++a) {
    for (std::size_t b = 0; b < census.size(); ++b) {
      const bool two = a == b ? census[a].all >= 2 : census[b].all >= 1;
      if (census[a].moving >= 1 && two) require(set_up, a, b);
    }
    if (census[a].moving == 0) continue;
    for (const Wall& wall : set_up.scene.walls) require(set_up, a, static_cast<std::size_t>(wall.material));
  }
}

}  // namespace grainproof::input
