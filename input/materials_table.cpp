// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"
#include "input/text.hpp"

namespace grainproof::input {

namespace {

constexpr std::pair<std::string_view, OrientationUpdate> orientations[] = {
    {"none", OrientationUpdate::none},
    {"exponential", OrientationUpdate::exponential},
    {"forward_euler", OrientationUpdate::forward_euler}};

std::optional<Elasticity> read_elasticity(const Table& table) {
  const auto modulus = table.find("youngs_modulus");
  const auto ratio = table.find("poisson_ratio");
  if (!modulus && !ratio) return std::nullopt;
  if (!ratio) modulus->refuse("youngs_modulus alone", "poisson_ratio beside it");
  if (!modulus) ratio->refuse("poisson_ratio alone", "youngs_modulus beside it");
  const Elasticity elasticity{modulus->positive(), ratio->number()};
  if (!(elasticity.poisson_ratio > -1.0 && elasticity.poisson_ratio <= 0.5))
    ratio->refuse("a number above -1 and up to 0.5");
  return elasticity;
}

}  // namespace

void read_bodies(const Table& table, Scene& scene) {
  table.only({"rotation", "orientation"});
  scene.rotation = table.boolean("rotation", false);
  const auto orientation = table.find("orientation");
  if (!orientation) return;
  scene.orientation = orientation->choice(orientations);
  if (!scene.rotation && scene.orientation != OrientationUpdate::none)
    orientation->refuse("orientation in a scene without rotation", "rotation = true beside it");
}

void read_materials(const Table& table, Scene& scene) {
  for (const Node& node : table.nodes()) {
    const Table material = node.table();
    material.only({"density", "youngs_modulus", "poisson_ratio"});
    scene.materials.push_back(
        {std::string(node.name()), material.at("density").positive(), read_elasticity(material)});
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
