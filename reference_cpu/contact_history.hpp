// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "reference_cpu/contact_force.hpp"
#include "reference_cpu/contact_walk.hpp"

namespace grainproof::reference {

/// Springs of the bodies that touch, from one evaluation of the forces to the next.
class ContactHistory {
 public:
  struct Memory {
    std::int32_t first;   ///< particle; for a wall its index after the particles
    std::int32_t second;  ///< particle
    ContactSprings springs;
  };

  /// What contacts remember before the first evaluation, by rising (first, second).
  explicit ContactHistory(std::vector<Memory> remembered) : walk_(std::move(remembered)) {}

  /// Starts an evaluation; springs are stretched for `elapsed` (s).
  void begin(double elapsed) {
    elapsed_ = elapsed;
    walk_.begin();
  }

  double elapsed() const { return elapsed_; }

  /// At rest for bodies that did not touch before. To be asked by rising (first, second).
  ContactSprings recall(std::int32_t first, std::int32_t second) {
    const Memory* met = walk_.meet(first, second);
    return met ? met->springs : ContactSprings{};
  }

  /// As recall(), but null for bodies that did not touch before.
  const ContactSprings* meet(std::int32_t first, std::int32_t second) {
    const Memory* met = walk_.meet(first, second);
    return met ? &met->springs : nullptr;
  }

  /// After the last meet(): what touched before the evaluation and does no more, by rising (first, second).
  const std::vector<Memory>& parted() { return walk_.parted(); }

  void keep(std::int32_t first, std::int32_t second, const ContactSprings& springs) {
    walk_.keep({first, second, springs});
  }

  /// Particle i becomes `place[i]`. What is displaced one way from the first to the second is displaced the
  /// other way from the second to the first.
  void renumber(const std::vector<std::int32_t>& place);

  const std::vector<Memory>& memories() const { return walk_.memories(); }

 private:
  ContactWalk<Memory> walk_;
  double elapsed_ = 0.0;
};

}  // namespace grainproof::reference
