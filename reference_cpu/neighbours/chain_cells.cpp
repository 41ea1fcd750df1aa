// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/neighbours/chain_cells.hpp"

#include <algorithm>
#include <cmath>

namespace grainproof::reference {
namespace {

std::int32_t clamped_index(double scaled, std::int32_t count) {
  return static_cast<std::int32_t>(std::clamp(scaled, 0.0, count - 1.0));
}

/// A period of more cells than this along one axis would overflow an index on the way.
constexpr double most_cells_along_axis = 1 << 20;

/// How many cells at least `width` wide fit; round-off must not make one narrower.
double cells_along(double extent, double width) {
  return std::clamp(std::floor(extent / (width * (1.0 + 1e-9))), 1.0, most_cells_along_axis);
}

/// Fewer, wider cells until there are not many more of them than particles.
void limit_cells(std::array<double, 3>& count, std::size_t particles) {
  const double most = 8.0 * static_cast<double>(particles) + 64.0;
  while (count[0] * count[1] * count[2] > most) {
    double& largest = *std::max_element(count.begin(), count.end());
    largest = std::ceil(0.5 * largest);
  }
}

}  // namespace

std::int32_t CellGrid::cell_of(const Vec3& position) const {
  const Vec3 scaled = (position - lower).cwiseProduct(inverse_width);
  return clamped_index(scaled.x(), count[0]) +
         count[0] * (clamped_index(scaled.y(), count[1]) + count[1] * clamped_index(scaled.z(), count[2]));
}

CellGrid grid_over(const Bodies& bodies, const PeriodicBox& box, double width) {
  Vec3 lower = bodies.body.front().position;
  Vec3 upper = lower;
  for (const Body& body : bodies.body) {
    lower = lower.cwiseMin(body.position);
    upper = upper.cwiseMax(body.position);
  }
  CellGrid grid;
  std::array<double, 3> count;
  for (int axis = 0; axis < 3; ++axis) {
    grid.periodic[axis] = box.periodic(axis);
    if (box.periodic(axis)) {
      lower[axis] = box.lower()[axis];
      upper[axis] = box.upper()[axis];
    }
    count[axis] = cells_along(upper[axis] - lower[axis], width);
  }
  limit_cells(count, bodies.size());
  grid.lower = lower;
  for (int axis = 0; axis < 3; ++axis) {
    grid.count[axis] = static_cast<std::int32_t>(count[axis]);
    const double extent = upper[axis] - lower[axis];
    grid.inverse_width[axis] = extent > 0.0 ? count[axis] / extent : 0.0;
  }
  return grid;
}

CellNeighbours::CellNeighbours(const CellGrid& grid, std::int32_t cell) {
  const std::array<std::int32_t, 3> at{cell % grid.count[0], cell / grid.count[0] % grid.count[1],
                                       cell / (grid.count[0] * grid.count[1])};
  // With one or two cells along an axis all of them touch already, so wrapping would repeat one.
  const auto along = [&](int axis, int offset) {
    const std::int32_t count = grid.count[axis];
    const std::int32_t index = at[axis] + offset;
    if (index >= 0 && index < count) return index;
    return grid.periodic[axis] && count > 2 ? (index + count) % count : -1;
  };
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dz = -1; dz <= 1; ++dz) {
        const std::int32_t x = along(0, dx), y = along(1, dy), z = along(2, dz);
        if (x >= 0 && y >= 0 && z >= 0) cells_[size_++] = x + grid.count[0] * (y + grid.count[1] * z);
      }
}

void ChainCells::fill(const CellGrid& grid, const Bodies& bodies) {
  grid_ = grid;
  head_.assign(grid.cells(), -1);
  next_.assign(bodies.size(), -1);
  cell_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    cell_[i] = grid.cell_of(bodies.body[i].position);
    next_[i] = head_[cell_[i]];
    head_[cell_[i]] = static_cast<std::int32_t>(i);
  }
}

std::vector<std::int32_t> ChainCells::order() const {
  std::vector<std::int32_t> particles;
  particles.reserve(next_.size());
  for (const std::int32_t head : head_) {
    const auto begin = static_cast<std::ptrdiff_t>(particles.size());
    for (std::int32_t i = head; i >= 0; i = next_[i]) particles.push_back(i);
    std::reverse(particles.begin() + begin, particles.end());
  }
  return particles;
}

void ChainCells::pair_with_chain(const Bodies& bodies, const PeriodicBox& box, double skin,
                                 std::int32_t particle, std::int32_t link) {
  for (; link >= 0; link = next_[link]) {
    const auto [low, high] = std::minmax(particle, link);
    if (belongs(bodies, box, skin, low, high)) found_.emplace_back(low, high);
  }
}

void ChainCells::list_pairs(const Bodies& bodies, const PeriodicBox& box, double skin, PairList& list) {
  found_.clear();
  for (std::int32_t cell = 0; cell < grid_.cells(); ++cell) {
    if (head_[cell] < 0) continue;
    const CellNeighbours neighbours(grid_, cell);
    for (std::int32_t i = head_[cell]; i >= 0; i = next_[i]) {
      pair_with_chain(bodies, box, skin, i, next_[i]);
      for (const std::int32_t other : neighbours)
        if (other > cell) pair_with_chain(bodies, box, skin, i, head_[other]);
    }
  }
  list.assign(bodies.size(), found_);
}

}  // namespace grainproof::reference
