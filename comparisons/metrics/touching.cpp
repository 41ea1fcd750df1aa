// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/touching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace grainproof {
namespace {

/// Particles by cells at least as wide as the largest diameter; periodic axes wrap.
class CellGrid {
 public:
  CellGrid(const Scene& scene, const Frame& frame) : scene_(scene), frame_(frame) {
    double largest = 0.0;
    for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
    for (int axis = 0; axis < 3; ++axis)
      cells_[axis] =
          std::max<std::int64_t>(1, static_cast<std::int64_t>(scene.domain.extent()[axis] / largest));
    for (std::size_t i = 0; i < scene.particles.size(); ++i) members_[key(cell_of(i))].push_back(i);
  }

  std::vector<Pair> overlapping_pairs() const {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < scene_.particles.size(); ++i)
      for (const std::int64_t neighbour : neighbours(cell_of(i))) add_overlaps(i, neighbour, pairs);
    return pairs;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(std::size_t particle) const {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
      const double part =
          (frame_.position[particle][axis] - scene_.domain.lower[axis]) / scene_.domain.extent()[axis];
      cell[axis] = std::clamp<std::int64_t>(
          static_cast<std::int64_t>(std::floor(part * static_cast<double>(cells_[axis]))), 0,
          cells_[axis] - 1);
    }
    return cell;
  }

  std::int64_t key(const Cell& cell) const { return (cell[2] * cells_[1] + cell[1]) * cells_[0] + cell[0]; }

  /// Keys of the cell and those around it, each once even where few cells wrap onto themselves.
  std::vector<std::int64_t> neighbours(const Cell& cell) const {
    std::vector<std::int64_t> keys;
    for (int n = 0; n < 27; ++n) {
      Cell other{cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1};
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis) {
        if (scene_.domain.periodic(axis)) other[axis] = (other[axis] + cells_[axis]) % cells_[axis];
        inside = inside && other[axis] >= 0 && other[axis] < cells_[axis];
      }
      if (inside) keys.push_back(key(other));
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
  }

  void add_overlaps(std::size_t i, std::int64_t cell, std::vector<Pair>& pairs) const {
    const auto found = members_.find(cell);
    if (found == members_.end()) return;
    for (const std::size_t j : found->second)
      if (j < i && gap(scene_, frame_, {i, j, 0}) < 0.0) pairs.push_back({i, j, 0});
  }

  const Scene& scene_;
  const Frame& frame_;
  std::array<std::int64_t, 3> cells_{};
  std::unordered_map<std::int64_t, std::vector<std::size_t>> members_;
};

}  // namespace

std::vector<Pair> touching_particles(const Scene& scene, const Frame& frame) {
  return CellGrid(scene, frame).overlapping_pairs();
}

std::vector<Pair> touching_walls(const Scene& scene, const Frame& frame) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
      if (const Pair pair{i, std::nullopt, w}; gap(scene, frame, pair) < 0.0) pairs.push_back(pair);
  return pairs;
}

}  // namespace grainproof
