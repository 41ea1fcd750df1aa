// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/onset/touching.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace grainproof::reference {

void Touching::renumber(const std::vector<std::int32_t>& place) {
  const auto particles = static_cast<std::int32_t>(place.size());
  for (Memory& memory : now_) {
    memory.second = place[memory.second];
    if (memory.first >= particles) continue;
    memory.first = place[memory.first];
    if (memory.second < memory.first) std::swap(memory.first, memory.second);
  }
  std::ranges::sort(now_, {}, [](const Memory& memory) { return std::tuple(memory.first, memory.second); });
}

}  // namespace grainproof::reference
