// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"
#include "input/text.hpp"

namespace grainproof::input {

void read_bodies(const Table& table) {
  table.only({"rotation"});
  if (const auto rotation = table.find("rotation"); rotation && rotation->boolean())
    rotation->refuse("false; bodies that rotate are not available");
}

void read_materials(const Table& table, Scene& scene) {
  for (const Node& node : table.nodes()) {
    const Table material = node.table();
    material.only({"density"});
    scene.materials.push_back({std::string(node.name()), material.at("density").positive()});
  }
  scene.contacts = ContactTable(scene.materials.size());
}

std::int32_t read_material_name(const Node& node, const Scene& scene) {
  const std::string wanted = node.text();
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (scene.materials[i].name == wanted) return static_cast<std::int32_t>(i);
    known.push_back(scene.materials[i].name);
  }
  node.refuse("a material of this file: " + meant(wanted, known));
}

}  // namespace grainproof::input
