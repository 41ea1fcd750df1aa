// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
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

  /// The cells within one of `cell`, each once.
  std::vector<Cell> around(const Cell& cell) const {
    std::vector<Cell> found;
    for (int i = 0; i < 27; ++i) {
      Cell next{cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1};
      for (int axis = 0; axis < 3; ++axis)
        if (domain.periodic(axis)) next[axis] = (next[axis] + cells[axis]) % cells[axis];
      found.push_back(next);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
};

Vec3 nearest_image(const Domain& domain, Vec3 difference) {
  for (int axis = 0; axis < 3; ++axis)
    if (domain.periodic(axis))
      difference[axis] -= domain.extent()[axis] * std::round(difference[axis] / domain.extent()[axis]);
  return difference;
}

}  // namespace

void each_contact(const Scene& scene, const Frame& frame,
                  const std::function<void(std::size_t, std::int64_t, double)>& visit) {
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
  const Grid grid(scene.domain, largest);
  std::map<Cell, std::vector<std::size_t>> earlier;
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    const Vec3& here = frame.position[i];
    const double radius = scene.particles[i].diameter / 2.0;
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
      if (const double gap = facing(scene.walls[w], here, frame.time).distance; gap < radius)
        visit(i, -1 - static_cast<std::int64_t>(w), radius - gap);
    const Cell cell = grid.cell_of(here);
    for (const Cell& near : grid.around(cell)) {
      const auto found = earlier.find(near);
      if (found == earlier.end()) continue;
      for (std::size_t j : found->second) {
        const double reach = radius + scene.particles[j].diameter / 2.0;
        const double apart = nearest_image(scene.domain, frame.position[j] - here).norm();
        if (apart < reach) visit(i, static_cast<std::int64_t>(j), reach - apart);
      }
    }
    earlier[cell].push_back(i);
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
