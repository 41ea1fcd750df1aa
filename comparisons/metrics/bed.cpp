// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/bed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "comparisons/metrics/pairs.hpp"

namespace grainproof {
namespace {

Vec3 up(const Scene& scene) {
  const auto* gravity = std::get_if<ConstantGravity>(&scene.gravity);
  return gravity && gravity->acceleration.norm() > 0.0 ? Vec3(-gravity->acceleration.normalized())
                                                       : Vec3::UnitZ();
}

double lowest_corner(const Domain& domain, const Vec3& upwards) {
  return domain.lower.cwiseProduct(upwards).cwiseMin(domain.upper.cwiseProduct(upwards)).sum();
}

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

  std::size_t overlapping_pairs() const {
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < scene_.particles.size(); ++i)
      for (const std::int64_t neighbour : neighbours(cell_of(i))) pairs += overlaps(i, neighbour);
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

  std::size_t overlaps(std::size_t i, std::int64_t cell) const {
    const auto found = members_.find(cell);
    if (found == members_.end()) return 0;
    return static_cast<std::size_t>(
        std::count_if(found->second.begin(), found->second.end(), [&](std::size_t j) {
          return j < i && gap(scene_, frame_, {i, j, 0}) < 0.0;
        }));
  }

  const Scene& scene_;
  const Frame& frame_;
  std::array<std::int64_t, 3> cells_{};
  std::unordered_map<std::int64_t, std::vector<std::size_t>> members_;
};

}  // namespace

Measured bed_height(const Scene& scene, const Observations& seen) {
  const Vec3 upwards = up(scene);
  const double floor = lowest_corner(scene.domain, upwards);
  double sum = 0.0;
  for (const Vec3& position : seen.frames.back().position) sum += position.dot(upwards) - floor;
  return Measured::of(2.0 * sum / static_cast<double>(scene.particles.size()));
}

Measured contact_number(const Scene& scene, const Observations& seen) {
  const CellGrid grid(scene, seen.frames.back());
  return Measured::of(2.0 * static_cast<double>(grid.overlapping_pairs()) /
                      static_cast<double>(scene.particles.size()));
}

}  // namespace grainproof
