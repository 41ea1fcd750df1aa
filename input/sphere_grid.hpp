// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
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

  /// Calls visit(index) for every inserted sphere that may be within reach, some of them twice.
  template <class Visit>
  void for_each_near(const Vec3& position, Visit&& visit) const {
    const Cell centre = cell_of(position);
    Cell cell;
    for (cell[0] = centre[0] - 1; cell[0] <= centre[0] + 1; ++cell[0])
      for (cell[1] = centre[1] - 1; cell[1] <= centre[1] + 1; ++cell[1])
        for (cell[2] = centre[2] - 1; cell[2] <= centre[2] + 1; ++cell[2])
          for (std::int64_t entry = first_[bucket_of(wrapped(cell))]; entry >= 0;
               entry = entries_[entry].next)
            if (entries_[entry].cell == wrapped(cell)) visit(entries_[entry].index);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Cell cell;
    std::size_t index;
    std::int64_t next;
  };

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

/// From a wall's surface to a point: negative behind a plane.
double distance_to(const WallShape& shape, const Vec3& point);

}  // namespace grainproof::input
