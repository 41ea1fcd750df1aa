// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"

namespace grainproof::input {
namespace {

constexpr std::pair<std::string_view, Boundary> boundaries[] = {
    {"open", Boundary::open}, {"periodic", Boundary::periodic}, {"wall", Boundary::wall}};

void read_boundaries(const Node& node, Domain& domain) {
  const auto elements = node.elements();
  if (elements.size() != 3) node.refuse("three of open, periodic or wall, one an axis");
  for (std::size_t axis = 0; axis < 3; ++axis) domain.boundary[axis] = elements[axis].choice(boundaries);
}

void add_face(Scene& scene, int axis, bool upper, std::int32_t material) {
  const char axes[] = {'x', 'y', 'z'};
  const Vec3 normal = (upper ? -1.0 : 1.0) * Vec3::Unit(axis);
  const std::string name = std::string("domain:") + axes[axis] + (upper ? "-upper" : "-lower");
  scene.walls.push_back(
      {name, material, Plane{upper ? scene.domain.upper : scene.domain.lower, normal}, Still{}});
}

}  // namespace

void read_domain(const Table& table, Scene& scene) {
  table.only({"lower", "upper", "boundary", "material"});
  Domain& domain = scene.domain;
  domain.lower = table.at("lower").vector();
  const Node upper = table.at("upper");
  domain.upper = upper.vector();
  if (!(domain.lower.array() < domain.upper.array()).all() || !domain.extent().allFinite())
    upper.refuse("upper = " + upper.label(), "more than lower along every axis");
  if (const auto boundary = table.find("boundary")) read_boundaries(*boundary, domain);
}

void read_domain_walls(const Table& table, Scene& scene) {
  bool walled = false;
  for (const Boundary boundary : scene.domain.boundary) walled = walled || boundary == Boundary::wall;
  const auto material = table.find("material");
  if (!walled) {
    if (material) material->refuse("no material, since no face of the domain is a wall");
    return;
  }
  const std::int32_t index = read_material_name(table.at("material"), scene);
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.domain.boundary[axis] != Boundary::wall) continue;
    add_face(scene, axis, false, index);
    add_face(scene, axis, true, index);
  }
}

}  // namespace grainproof::input
