// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"

namespace grainproof::input {
namespace {

/// A plane across a periodic axis would meet its own images.
void refuse_across_period(const Node& node, const Vec3& normal, const Domain& domain) {
  for (int axis = 0; axis < 3; ++axis)
    if (domain.periodic(axis) && normal[axis] != 0.0)
      node.refuse("a plane across a periodic axis", "a normal without a component along it");
}

Plane read_plane(const Table& table, const Domain& domain) {
  table.only({"point", "normal"});
  const Vec3 point = table.at("point").vector();
  const Node normal = table.at("normal");
  const Vec3 unit = normal.vector().stableNormalized();
  // A vector whose length under- or overflows has no direction to speak of.
  if (!(std::abs(unit.norm() - 1.0) < 1e-9))
    normal.refuse("normal = " + normal.label(), "a vector with a length above 0");
  refuse_across_period(normal, unit, domain);
  return {point, unit};
}

Rectangle read_rectangle(const Table& table) {
  table.only({"lower", "upper"});
  const Node upper = table.at("upper");
  const Rectangle rectangle{table.at("lower").vector(), upper.vector()};
  const Vec3 extent = rectangle.upper - rectangle.lower;
  const auto flat = (extent.array() == 0.0).count();
  if (flat != 1 || (extent.array() < 0.0).any() || !extent.allFinite())
    upper.refuse("upper = " + upper.label(),
                 "a flat rectangle: equal to lower along exactly one axis and more along the others");
  return rectangle;
}

Wall read_wall(const Table& table, const Scene& scene) {
  table.only({"name", "material", "plane", "rectangle"});
  const auto name = table.find("name");
  const auto plane = table.find("plane");
  const auto rectangle = table.find("rectangle");
  if (plane.has_value() == rectangle.has_value())
    table.whole().refuse(plane ? "both plane and rectangle" : "neither plane nor rectangle",
                         "one of the two");
  Wall wall{name ? name->text() : "wall:" + std::to_string(scene.walls.size()),
            read_material_name(table.at("material"), scene),
            {}};
  if (plane) wall.shape = read_plane(plane->table(), scene.domain);
  if (rectangle) wall.shape = read_rectangle(rectangle->table());
  return wall;
}

}  // namespace

void read_walls(const std::vector<Node>& tables, Scene& scene) {
  for (const Node& node : tables) scene.walls.push_back(read_wall(node.table(), scene));
}

}  // namespace grainproof::input
