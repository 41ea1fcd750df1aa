// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/near_walls.hpp"

#include <algorithm>
#include <cmath>

namespace grainproof::opencl {
namespace {

/// Where a plane comes nearest to the corner of the domain that lies deepest on its side.
bool can_touch(const Plane& plane, const Domain& domain, double reach) {
  Vec3 deepest;
  for (int axis = 0; axis < 3; ++axis)
    deepest[axis] = plane.normal[axis] > 0.0 ? domain.lower[axis] : domain.upper[axis];
  return (deepest - plane.point).dot(plane.normal) < reach;
}

bool can_touch(const Rectangle& rectangle, const Domain& domain, double reach) {
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.periodic(axis)) continue;
    if (rectangle.lower[axis] > domain.upper[axis] + reach) return false;
    if (rectangle.upper[axis] < domain.lower[axis] - reach) return false;
  }
  return true;
}

/// Edges beyond every particle's reach come nearer; no closest point to a centre in the domain changes.
Rectangle clipped(const Rectangle& rectangle, const Domain& domain, double reach) {
  const Vec3 margin = Vec3::Constant(reach);
  const Vec3 lowest = domain.lower - margin, highest = domain.upper + margin;
  return {rectangle.lower.cwiseMax(lowest).cwiseMin(highest),
          rectangle.upper.cwiseMin(highest).cwiseMax(lowest)};
}

Vec3 reference_of(const Rectangle& rectangle) {
  return rectangle.lower;
}
Vec3 reference_of(const Plane& plane) {
  return plane.point;
}
Vec3 reference_of(const Cylinder& cylinder) {
  return cylinder.point;
}

/// Sorts the walls of a scene by shape.
class Sorter {
 public:
  explicit Sorter(const Scene& scene) : domain_(scene.domain), reach_(largest_reach(scene)) {}

  void add(const Wall& wall, std::int32_t index) {
    std::visit([&](const auto& shape) { add(shape, wall, index); }, wall.shape);
  }
  NearWalls sorted() {
    std::int32_t row = 0;
    const auto number = [&](auto& walls) {
      for (auto& wall : walls) wall.row = changes_place(wall.motion) ? row++ : -1;
    };
    number(near_.planes), number(near_.rectangles), number(near_.cylinders);
    return std::move(near_);
  }

 private:
  void add(const Plane& plane, const Wall& wall, std::int32_t index) {
    if (changes_place(wall.motion) || can_touch(plane, domain_, reach_))
      near_.planes.push_back(made(plane, plane, wall, index));
  }
  void add(const Rectangle& rectangle, const Wall& wall, std::int32_t index) {
    if (changes_place(wall.motion))
      near_.rectangles.push_back(made(rectangle, rectangle, wall, index));
    else if (can_touch(rectangle, domain_, reach_))
      near_.rectangles.push_back(made(clipped(rectangle, domain_, reach_), rectangle, wall, index));
  }
  void add(const Cylinder& cylinder, const Wall& wall, std::int32_t index) {
    near_.cylinders.push_back(made(cylinder, cylinder, wall, index));
  }
  template <class Shape>
  static NearWall<Shape> made(const Shape& shape, const Shape& drawn, const Wall& wall, std::int32_t index) {
    return {shape, wall.material, index, wall.motion, reference_of(drawn), -1};
  }

  const Domain& domain_;
  double reach_;
  NearWalls near_;
};

}  // namespace

bool changes_place(const WallMotion& motion) {
  return std::holds_alternative<Translating>(motion) || std::holds_alternative<Vibrating>(motion);
}

std::size_t NearWalls::moving() const {
  std::size_t moving = 0;
  each([&](const auto& wall) { moving += wall.row >= 0 ? 1 : 0; });
  return moving;
}

bool NearWalls::any_moves() const {
  bool moves = false;
  each([&](const auto& wall) { moves = moves || !std::holds_alternative<Still>(wall.motion); });
  return moves;
}

Rectangle within_reach(const Rectangle& rectangle, const Domain& domain, double reach) {
  Rectangle seen = clipped(rectangle, domain, 1.001 * reach);
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain.periodic(axis)) continue;
    const double period = domain.extent()[axis], length = rectangle.upper[axis] - rectangle.lower[axis];
    const double middle = rectangle.lower[axis] + length / 2, half = std::min(length / 2, period / 2);
    const double inside = middle - period * std::floor((middle - domain.lower[axis]) / period);
    seen.lower[axis] = inside - half;
    seen.upper[axis] = inside + half;
  }
  return seen;
}

double largest_reach(const Scene& scene) {
  double reach = 0.0;
  for (const Particle& p : scene.particles) reach = std::max({reach, p.diameter / 2, p.effect_diameter / 2});
  return reach;
}

NearWalls near_walls(const Scene& scene) {
  Sorter sorter(scene);
  for (std::size_t i = 0; i < scene.walls.size(); ++i)
    sorter.add(scene.walls[i], static_cast<std::int32_t>(i));
  return sorter.sorted();
}

}  // namespace grainproof::opencl
