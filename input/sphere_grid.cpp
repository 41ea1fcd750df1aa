// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/sphere_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace grainproof::input {
namespace {

/// Cells along one axis at most: keeps cell numbers exact whatever the sizes are.
constexpr double most_cells = 0x1p40;

}  // namespace

SphereGrid::SphereGrid(const Domain& domain, double reach, std::size_t expected)
    : domain_(domain), first_(std::bit_ceil(2 * expected + 1), -1) {
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = domain.extent()[axis];
    const double cells = std::clamp(std::floor(extent / reach), 1.0, most_cells);
    count_[axis] = static_cast<std::int64_t>(cells);
    edge_[axis] = extent / cells;
  }
  entries_.reserve(expected);
}

void SphereGrid::insert(std::size_t index, const Vec3& position) {
  const Cell cell = wrapped(cell_of(position));
  std::int64_t& first = first_[bucket_of(cell)];
  entries_.push_back({cell, index, first});
  first = static_cast<std::int64_t>(entries_.size()) - 1;
}

SphereGrid::Cell SphereGrid::cell_of(const Vec3& position) const {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double along = std::floor((position[axis] - domain_.lower[axis]) / edge_[axis]);
    cell[axis] = static_cast<std::int64_t>(std::clamp(along, -1.0, static_cast<double>(count_[axis])));
  }
  return cell;
}

/// Cells lie at most one beyond those of `cell_of`, so two beyond the grid.
SphereGrid::Cell SphereGrid::wrapped(Cell cell) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain_.periodic(axis)) continue;
    while (cell[axis] < 0) cell[axis] += count_[axis];
    while (cell[axis] >= count_[axis]) cell[axis] -= count_[axis];
  }
  return cell;
}

std::size_t SphereGrid::bucket_of(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t along : cell)
    hash = (hash ^ static_cast<std::uint64_t>(along)) * 0x9e3779b97f4a7c15u;
  return (hash >> 20) & (first_.size() - 1);
}

Vec3 nearest_image(const Domain& domain, const Vec3& from, const Vec3& to) {
  Vec3 apart = to - from;
  for (int axis = 0; axis < 3; ++axis)
    if (domain.periodic(axis))
      apart[axis] -= domain.extent()[axis] * std::round(apart[axis] / domain.extent()[axis]);
  return apart;
}

double distance_to(const WallShape& shape, const Vec3& point) {
  if (const auto* plane = std::get_if<Plane>(&shape)) return (point - plane->point).dot(plane->normal);
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    const double from_axis = cylinder->axis.cross(point - cylinder->point).norm();
    return cylinder->side == Cylinder::Side::inside ? cylinder->radius - from_axis
                                                    : from_axis - cylinder->radius;
  }
  const auto& rectangle = std::get<Rectangle>(shape);
  return (point - point.cwiseMax(rectangle.lower).cwiseMin(rectangle.upper)).norm();
}

}  // namespace grainproof::input
