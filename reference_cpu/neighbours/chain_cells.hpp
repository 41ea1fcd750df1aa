// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "reference_cpu/neighbours/pair_list.hpp"

namespace grainproof::reference {

/// A grid of cells over a box; wraps along periodic axes.
struct CellGrid {
  Vec3 lower;
  std::array<std::int32_t, 3> count;  ///< cells along each axis
  Vec3 inverse_width;                 ///< 1/m; positions are multiplied by it, never divided (docs/errata.md)
  std::array<bool, 3> periodic;

  std::int32_t cells() const { return count[0] * count[1] * count[2]; }
  /// Along x first, then y, then z; positions outside belong to the nearest cell.
  std::int32_t cell_of(const Vec3& position) const;
};

/// Cells at least `width` wide over the particles, or over the whole period; more particles than
/// cells where they are sparse.
CellGrid grid_over(const Bodies& bodies, const PeriodicBox& box, double width);

/// The cells that touch a cell, itself among them, each once. Offsets run −1, 0, 1 with z fastest.
class CellNeighbours {
 public:
  CellNeighbours(const CellGrid& grid, std::int32_t cell);
  const std::int32_t* begin() const { return cells_.data(); }
  const std::int32_t* end() const { return cells_.data() + size_; }

 private:
  std::array<std::int32_t, 27> cells_;
  std::size_t size_ = 0;
};

/// Sweetman chapter 3: the chain of a cell begins at its head, the particle put in last, and each
/// particle names the next. −1 ends a chain.
class ChainCells {
 public:
  void fill(const CellGrid& grid, const Bodies& bodies);

  std::int32_t head(std::int32_t cell) const { return head_[cell]; }
  std::int32_t next(std::int32_t particle) const { return next_[particle]; }
  std::int32_t cell(std::int32_t particle) const { return cell_[particle]; }

  /// All particles cell by cell, rising within each.
  std::vector<std::int32_t> order() const;

  /// Every close pair once: within a cell, and between a cell and its neighbours of higher index.
  void list_pairs(const Bodies& bodies, const PeriodicBox& box, double skin, PairList& list);

 private:
  void pair_with_chain(const Bodies& bodies, const PeriodicBox& box, double skin, std::int32_t particle,
                       std::int32_t link);

  CellGrid grid_;
  std::vector<std::int32_t> head_, next_, cell_;
  std::vector<PairList::Pair> found_;
};

}  // namespace grainproof::reference
