// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/sections.hpp"
#include "reference_cpu/neighbours/chain_cells.hpp"
#include "reference_cpu/neighbours/near_walls.hpp"
#include "reference_cpu/neighbours/pair_list.hpp"
#include "reference_cpu/neighbours/verlet_list.hpp"

namespace grainproof::reference {

/// Who may touch whom, found the way the scene asks for and only when it may have changed.
class Neighbours {
 public:
  /// Keeps references to the walls and the box.
  Neighbours(const Scene& scene, const Walls& walls, const Bodies& bodies, const PeriodicBox& box);

  /// Whether a contact could be missing. Positions must be finite and inside the domain from here on.
  bool outdated(const Bodies& bodies) const;
  void list(const Bodies& bodies);

  /// Indices of all particles, cell by cell.
  std::vector<std::int32_t> order_in_space(const Bodies& bodies);

  const PairList& pairs() const { return pairs_; }
  const NearWalls& walls() const { return near_walls_; }
  std::int64_t rebuilds() const { return lists_ - 1; }

  /// The list as it is, and what tells when it is outdated.
  void pack_into(Sections& own) const;
  void unpack_from(const Sections& own);

 private:
  enum class Way { nothing_to_find, all_pairs, cells, verlet_list };

  static Way way_for(const Scene& scene, const Bodies& bodies);
  double skin() const;
  void fill_cells(const Bodies& bodies);

  Way way_;
  const Walls& walls_;
  const PeriodicBox& box_;
  double largest_reach_;
  VerletList verlet_;
  ChainCells chains_;
  PairList pairs_;
  NearWalls near_walls_;
  std::int64_t lists_ = 0;
};

}  // namespace grainproof::reference
