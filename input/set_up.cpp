// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"

#include <algorithm>

namespace grainproof::input {
namespace {

std::vector<Node> tables_of(const Table& table, std::string_view key) {
  const auto found = table.find(key);
  return found ? found->tables() : std::vector<Node>{};
}

void sort_by_id(std::vector<Particle>& particles) {
  std::sort(particles.begin(), particles.end(),
            [](const Particle& a, const Particle& b) { return a.id < b.id; });
}

}  // namespace

const Node& place_of(const SetUp& set_up, std::size_t particle) {
  const auto after =
      std::upper_bound(set_up.groups.begin(), set_up.groups.end(), particle,
                       [](std::size_t index, const Group& group) { return index < group.first; });
  const Group& group = *std::prev(after);
  return group.positions.size() == 1 ? group.positions.front() : group.positions[particle - group.first];
}

SetUp read_set_up(const Document& document, const Reading& reading) {
  const Table file = root(document);
  SetUp set_up;
  if (const auto title = file.find("title")) set_up.scene.title = title->text();
  read_run(file.at("run").table(), set_up);
  read_domain(file.at("domain").table(), set_up.scene);
  if (const auto bodies = file.find("bodies")) read_bodies(bodies->table(), set_up.scene);
  if (const auto materials = file.find("material")) read_materials(materials->table(), set_up.scene);
  read_contacts(tables_of(file, "contact"), set_up.scene);
  read_domain_walls(file.at("domain").table(), set_up.scene);
  read_walls(tables_of(file, "wall"), set_up);
  read_particles(tables_of(file, "particles"), reading, set_up);
  if (const auto field = file.find("field")) read_field(field->table(), set_up.scene);
  check_set_up(set_up, document);
  sort_by_id(set_up.scene.particles);
  return set_up;
}

}  // namespace grainproof::input
