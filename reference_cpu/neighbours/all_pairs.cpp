// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/neighbours/all_pairs.hpp"

namespace grainproof::reference {

void list_all_pairs(const Bodies& bodies, const PeriodicBox& box, double skin, PairList& list) {
  const auto count = static_cast<std::int32_t>(bodies.size());
  list.begin(bodies.size());
  for (std::int32_t i = 0; i < count; ++i) {
    for (std::int32_t j = i + 1; j < count; ++j)
      if (belongs(bodies, box, skin, i, j)) list.append_partner(j);
    list.end_particle();
  }
}

}  // namespace grainproof::reference
