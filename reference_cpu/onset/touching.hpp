// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "reference_cpu/contact_force.hpp"
#include "reference_cpu/contact_walk.hpp"

namespace grainproof::reference {

/// ContactHistory for contacts of which nothing is known but that they touch: an eighth of its size.
class Touching {
 public:
  struct Memory {
    std::int32_t first;   ///< particle; for a wall its index after the particles
    std::int32_t second;  ///< particle
  };

  explicit Touching(std::vector<Memory> remembered = {}) : walk_(std::move(remembered)) {}

  void begin() { walk_.begin(); }

  /// Null for bodies that did not touch before. To be asked by rising (first, second).
  const ContactSprings* meet(std::int32_t first, std::int32_t second) {
    return walk_.meet(first, second) ? &at_rest_ : nullptr;
  }

  void keep(std::int32_t first, std::int32_t second, const ContactSprings&) { walk_.keep({first, second}); }

  const std::vector<Memory>& parted() { return walk_.parted(); }

  /// Particle i becomes `place[i]`.
  void renumber(const std::vector<std::int32_t>& place) {
    walk_.renumber(place, [](Memory&) {});
  }

  const std::vector<Memory>& memories() const { return walk_.memories(); }

 private:
  ContactWalk<Memory> walk_;
  ContactSprings at_rest_;
};

}  // namespace grainproof::reference
