// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/contacts.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "comparisons/metrics/walls.hpp"

namespace grainproof::report {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// Cells at least one diameter wide; along a periodic axis a whole number of them fills the domain.
struct Grid {
  const Domain& domain;
  Cell cells{};
  Vec3 width = Vec3::Zero();

  Grid(const Domain& box, double diameter) : domain(box) {
    for (int axis = 0; axis < 3; ++axis) {
      cells[axis] =
          std::clamp<std::int64_t>(std::llround(std::floor(box.extent()[axis] / diameter)), 1, 1 << 20);
      width[axis] = box.extent()[axis] / static_cast<double>(cells[axis]);
    }
  }

  Cell cell_of(const Vec3& position) const {
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis) {
      const double place = std::floor((position[axis] - domain.lower[axis]) / width[axis]);
      cell[axis] = std::clamp<std::int64_t>(static_cast<std::int64_t>(place), 0, cells[axis] - 1);
    }
    return cell;
  }

  /// The places within one of `place` along an axis, each once, and how many there are.
  std::pair<std::array<std::int64_t, 3>, int> around(std::int64_t place, int axis) const {
    std::array<std::int64_t, 3> found{};
    int count = 0;
    const std::int64_t all = cells[axis];
    const bool wraps = domain.periodic(axis) && all >= 3;
    for (std::int64_t at = place - 1; at <= place + 1; ++at) {
      if (wraps)
        found[count++] = (at + all) % all;
      else if (at >= 0 && at < all)
        found[count++] = at;
    }
    return {found, count};
  }
};

/// Particles by their cell: chains in a table of so many places that few cells share one.
class Chains {
 public:
  explicit Chains(std::size_t particles)
      : first_(std::bit_ceil(particles + 1), none), next_(particles), cell_(particles) {}

  void insert(std::size_t i, const Cell& cell) {
    std::size_t& first = first_[place_of(cell)];
    cell_[i] = cell;
    next_[i] = first;
    first = i;
  }

  template <class Visit>
  void each_in(const Cell& cell, Visit&& visit) const {
    for (std::size_t i = first_[place_of(cell)]; i != none; i = next_[i])
      if (same(cell_[i], cell)) visit(i);
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  static bool same(const Cell& a, const Cell& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

  std::size_t place_of(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t along : cell)
      hash = (hash ^ static_cast<std::uint64_t>(along)) * 0x9e3779b97f4a7c15u;
    return (hash >> 20) & (first_.size() - 1);
  }

  std::vector<std::size_t> first_, next_;
  std::vector<Cell> cell_;
};

template <class Visit>
void each_around(const Grid& grid, const Cell& cell, Visit&& visit) {
  const auto [xs, nx] = grid.around(cell[0], 0);
  const auto [ys, ny] = grid.around(cell[1], 1);
  const auto [zs, nz] = grid.around(cell[2], 2);
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) visit(Cell{xs[i], ys[j], zs[k]});
}

Vec3 nearest_image(const Domain& domain, const Vec3& extent, Vec3 difference) {
  for (int axis = 0; axis < 3; ++axis)
    if (domain.periodic(axis) && std::abs(difference[axis]) > 0.5 * extent[axis])
      difference[axis] -= extent[axis] * std::round(difference[axis] / extent[axis]);
  return difference;
}

}  // namespace

void each_contact(const Scene& scene, const Frame& frame,
                  const std::function<void(std::size_t, std::int64_t, double)>& visit) {
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
  const Grid grid(scene.domain, largest);
  const Vec3 extent = scene.domain.extent();
  Chains earlier(frame.position.size());
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    const Vec3& here = frame.position[i];
    const double radius = scene.particles[i].diameter / 2.0;
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
      if (const double gap = facing(scene.walls[w], here, frame.time).distance; gap < radius)
        visit(i, -1 - static_cast<std::int64_t>(w), radius - gap);
    const auto meet = [&](std::size_t j) {
      const double reach = radius + scene.particles[j].diameter / 2.0;
      const double square = nearest_image(scene.domain, extent, frame.position[j] - here).squaredNorm();
      if (const double apart = std::sqrt(square); apart < reach)
        visit(i, static_cast<std::int64_t>(j), reach - apart);
    };
    const Cell cell = grid.cell_of(here);
    each_around(grid, cell, [&](const Cell& near) { earlier.each_in(near, meet); });
    earlier.insert(i, cell);
  }
}

ContactCount count_contacts(const Scene& scene, const Frame& frame) {
  ContactCount count;
  each_contact(scene, frame, [&](std::size_t, std::int64_t other, double) {
    (other < 0 ? count.walls : count.pairs) += 1;
  });
  return count;
}

}  // namespace grainproof::report
