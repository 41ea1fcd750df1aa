// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"

namespace grainproof::input {
namespace {

constexpr std::pair<std::string_view, Cylinder::Side> sides[] = {{"inside", Cylinder::Side::inside},
                                                                 {"outside", Cylinder::Side::outside}};

/// A vector whose length under- or overflows has no direction to speak of.
Vec3 read_direction(const Node& node) {
  const Vec3 unit = node.vector().stableNormalized();
  if (!(std::abs(unit.norm() - 1.0) < 1e-9))
    node.refuse(std::string(node.name()) + " = " + node.label(), "a vector with a length above 0");
  return unit;
}

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
  const Vec3 unit = read_direction(normal);
  refuse_across_period(normal, unit, domain);
  return {point, unit};
}

Cylinder read_cylinder(const Table& table) {
  table.only({"point", "axis", "radius", "side"});
  return {table.at("point").vector(), read_direction(table.at("axis")), table.at("radius").positive(),
          table.at("side").choice(sides)};
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

WallShape read_shape(const Table& table, const Domain& domain) {
  const auto plane = table.find("plane");
  const auto cylinder = table.find("cylinder");
  const auto rectangle = table.find("rectangle");
  const int given = int{plane.has_value()} + int{cylinder.has_value()} + int{rectangle.has_value()};
  if (given != 1)
    table.whole().refuse(given == 0 ? "neither plane, cylinder nor rectangle" : "more than one shape",
                         "one of plane, cylinder and rectangle");
  if (plane) return read_plane(plane->table(), domain);
  if (cylinder) return read_cylinder(cylinder->table());
  return read_rectangle(rectangle->table());
}

WallMotion read_motion(const Table& table, const WallShape& shape) {
  table.only({"velocity", "rate", "amplitude", "frequency", "phase"});
  const auto velocity = table.find("velocity");
  const auto rate = table.find("rate");
  const auto amplitude = table.find("amplitude");
  if (int{velocity.has_value()} + int{rate.has_value()} + int{amplitude.has_value()} != 1)
    table.whole().refuse("a motion of no known kind", "one of velocity, rate and amplitude");
  if (!amplitude) table.only({"velocity", "rate"});
  if (velocity) return Translating{velocity->vector()};
  if (amplitude) {
    const auto phase = table.find("phase");
    return Vibrating{amplitude->vector(), table.at("frequency").positive(), phase ? phase->number() : 0.0};
  }
  if (std::holds_alternative<Rectangle>(shape))
    rate->refuse("a rectangle that turns", "a plane or a cylinder, which turn within themselves");
  return Rotating{rate->number()};
}

Wall read_wall(const Table& table, const Scene& scene) {
  table.only({"name", "material", "plane", "cylinder", "rectangle", "motion"});
  const auto name = table.find("name");
  Wall wall{name ? name->text() : "wall:" + std::to_string(scene.walls.size()),
            read_material_name(table.at("material"), scene), read_shape(table, scene.domain), Still{}};
  if (const auto motion = table.find("motion")) wall.motion = read_motion(motion->table(), wall.shape);
  return wall;
}

}  // namespace

void read_walls(const std::vector<Node>& tables, SetUp& set_up) {
  for (const Node& node : tables) {
    set_up.scene.walls.push_back(read_wall(node.table(), set_up.scene));
    set_up.walls.push_back(node);
  }
}

}  // namespace grainproof::input
