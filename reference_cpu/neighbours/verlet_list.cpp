// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/neighbours/verlet_list.hpp"

#include <algorithm>

namespace grainproof::reference {

bool VerletList::outdated(const Bodies& bodies, const PeriodicBox& box) const {
  if (position_when_made_.size() != bodies.size()) return true;
  double largest_square = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec3 moved = box.nearest_image(bodies.body[i].position - position_when_made_[i]);
    largest_square = std::max(largest_square, moved.squaredNorm());
  }
  return 4.0 * largest_square > skin_ * skin_;
}

void VerletList::made(const Bodies& bodies) {
  position_when_made_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) position_when_made_[i] = bodies.body[i].position;
}

}  // namespace grainproof::reference
