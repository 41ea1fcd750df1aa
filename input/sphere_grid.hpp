// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::input {

/// Spheres hashed by cell, so that the close ones are found without asking every pair.
class SphereGrid {
 public:
  /// `reach`: the largest centre distance that `for_each_near` has to find.
  SphereGrid(const Domain& domain, double reach, std::size_t expected);

  void insert(std::size_t index, const Vec3& position);

  /// Whether holds(index) is true for an inserted sphere that may be within reach. Stops at the first;
  /// may ask one of them twice.
  template <class Holds>
  bool any_near(const Vec3& position, Holds&& holds) const {
    if (entries_.size() <= few)
      return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return holds(e.index); });
    const Cell centre = cell_of(position);
    for (int n = 0; n < 27; ++n) {
      const Cell cell = wrapped({centre[0] + n % 3 - 1, centre[1] + n / 3 % 3 - 1, centre[2] + n / 9 - 1});
      for (std::int64_t at = first_[bucket_of(cell)]; at >= 0; at = entries_[at].next)
        if (same(entries_[at].cell, cell) && holds(entries_[at].index)) return true;
    }
    return false;
  }

 private:
  /// So many are asked sooner than the 27 cells around.
  static constexpr std::size_t few = 8;
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Cell cell;
    std::size_t index;
    std::int64_t next;
  };

  static bool same(const Cell& a, const Cell& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

  /// Beside the grid where the position is outside the domain.
  Cell cell_of(const Vec3& position) const;
  Cell wrapped(Cell cell) const;
  std::size_t bucket_of(const Cell& cell) const;

  Domain domain_;
  Vec3 edge_;
  Cell count_;
  std::vector<std::int64_t> first_;
  std::vector<Entry> entries_;
};

/// From one centre to another, to the nearest image along periodic axes.
Vec3 nearest_image(const Domain& domain, const Vec3& from, const Vec3& to);

/// From a wall's surface to a point: negative behind a plane and in a cylinder's solid.
double distance_to(const WallShape& shape, const Vec3& point);

}  // namespace grainproof::input
