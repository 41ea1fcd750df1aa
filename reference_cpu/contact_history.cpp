// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/contact_history.hpp"

#include <algorithm>

namespace grainproof::reference {

void ContactHistory::renumber(const std::vector<std::int32_t>& place) {
  const auto particles = static_cast<std::int32_t>(place.size());
  for (Memory& memory : now_) {
    memory.second = place[memory.second];
    if (memory.first >= particles) continue;
    memory.first = place[memory.first];
    if (memory.first < memory.second) continue;
    std::swap(memory.first, memory.second);
    memory.springs.displacement *= -1.0;
    memory.springs.rolling_torque *= -1.0;
  }
  std::ranges::sort(now_, [](const Memory& a, const Memory& b) { return precedes(a, b.first, b.second); });
}

}  // namespace grainproof::reference
