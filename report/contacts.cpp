// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "comparisons/metrics/walls.hpp"

namespace grainproof::report {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// Cells at least one diameter wide, and so much wider that there are no more than a few for each particle;
/// along a periodic axis a whole number of them fills the domain.
struct Grid {
  const Domain& domain;
  Cell cells{};
  Vec3 width = Vec3::Zero();

  Grid(const Domain& box, double diameter, std::size_t particles) : domain(box) {
    const double most = 4.0 * static_cast<double>(particles) + 64.0;
    for (double least = diameter; width.isZero() || count() > most; least *= 1.25)
      for (int axis = 0; axis < 3; ++axis) {
        cells[axis] =
            std::clamp<std::int64_t>(std::llround(std::floor(box.extent()[axis] / least)), 1, 1 << 20);
        width[axis] = box.extent()[axis] / static_cast<double>(cells[axis]);
      }
  }

  double count() const {
    return static_cast<double>(cells[0]) * static_cast<double>(cells[1]) * static_cast<double>(cells[2]);
  }

  bool has(const Cell& cell) const {
    for (int axis = 0; axis < 3; ++axis)
      if (cell[axis] < 0 || cell[axis] >= cells[axis]) return false;
    return true;
  }

  std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>((cell[2] * cells[1] + cell[1]) * cells[0] + cell[0]);
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
  const Grid grid(scene.domain, largest, frame.position.size());
  // Of each cell the particle that came last, and of each particle the one before it in its cell.
  constexpr std::int64_t none = -1;
  std::vector<std::int64_t> last(static_cast<std::size_t>(grid.count()), none);
  std::vector<std::int64_t> before(frame.position.size(), none);
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    const Vec3& here = frame.position[i];
    const double radius = scene.particles[i].diameter / 2.0;
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
      if (const double gap = facing(scene.walls[w], here, frame.time).distance; gap < radius)
        visit(i, -1 - static_cast<std::int64_t>(w), radius - gap);
    const Cell cell = grid.cell_of(here);
    for (const Cell& near : grid.around(cell)) {
      if (!grid.has(near)) continue;
      for (std::int64_t k = last[grid.index(near)]; k != none; k = before[static_cast<std::size_t>(k)]) {
        const auto j = static_cast<std::size_t>(k);
        const double reach = radius + scene.particles[j].diameter / 2.0;
        const double apart = nearest_image(scene.domain, frame.position[j] - here).norm();
        if (apart < reach) visit(i, k, reach - apart);
      }
    }
    before[i] = std::exchange(last[grid.index(cell)], static_cast<std::int64_t>(i));
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
