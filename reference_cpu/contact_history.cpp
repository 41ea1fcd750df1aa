// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/contact_history.hpp"

namespace grainproof::reference {

void ContactHistory::renumber(const std::vector<std::int32_t>& place) {
  walk_.renumber(place, [](Memory& memory) {
    memory.springs.displacement *= -1.0;
    memory.springs.rolling_torque *= -1.0;
  });
}

}  // namespace grainproof::reference
