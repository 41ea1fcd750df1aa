// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "model/sections.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/contact_history.hpp"
#include "reference_cpu/neighbours/neighbours.hpp"
#include "reference_cpu/onset/touching.hpp"

namespace grainproof::reference {

/// Numbers the bodies along the cells now and then, so that those near each other lie near each other in
/// memory: with ids that are shuffled in space a step takes half as long again. It changes the order in which
/// the contacts of a particle are summed, so canonical runs are never renumbered (docs/determinism.md).
class SpaceOrder {
 public:
  explicit SpaceOrder(const Scene& scene);

  /// To be called before a list is made. Whoever kept an index is told by the bodies' `origin`.
  void before_list(Neighbours& neighbours, Bodies& bodies, ContactHistory& history, Touching& touching);

  void pack_into(Sections& own) const { pack_one(own, "space_order.lists", lists_); }
  void unpack_from(const Sections& own) { unpack_one(own, "space_order.lists", lists_); }

 private:
  bool sorts_;
  std::int64_t lists_ = 0;
};

}  // namespace grainproof::reference
