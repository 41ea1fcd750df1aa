// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "reference_cpu/contact_force.hpp"

namespace grainproof::reference {

/// Springs of the bodies that touch, from one evaluation of the forces to the next.
/// Contacts are gone through by rising (first, second), whoever found them, so the memory of one is
/// met by going along those of the evaluation before: it hangs on no list, and none that is rebuilt
/// can lose it. What is not kept has parted and is forgotten.
class ContactHistory {
 public:
  struct Memory {
    std::int32_t first;   ///< particle; for a wall its index after the particles
    std::int32_t second;  ///< particle
    ContactSprings springs;
  };

  /// What contacts remember before the first evaluation, by rising (first, second).
  explicit ContactHistory(std::vector<Memory> remembered) : now_(std::move(remembered)) {}

  /// Starts an evaluation; springs are stretched for `elapsed` (s).
  void begin(double elapsed) {
    elapsed_ = elapsed;
    before_.swap(now_);
    now_.clear();
    parted_.clear();
    next_ = 0;
  }

  double elapsed() const { return elapsed_; }

  /// At rest for bodies that did not touch before. To be asked by rising (first, second).
  ContactSprings recall(std::int32_t first, std::int32_t second) {
    while (next_ < before_.size() && precedes(before_[next_], first, second)) ++next_;
    if (next_ == before_.size() || before_[next_].first != first || before_[next_].second != second)
      return {};
    return before_[next_].springs;
  }

  /// As recall(), but null for bodies that did not touch before, and those that touch no more are set aside.
  const ContactSprings* meet(std::int32_t first, std::int32_t second) {
    while (next_ < before_.size() && precedes(before_[next_], first, second))
      parted_.push_back(before_[next_++]);
    if (next_ == before_.size() || before_[next_].first != first || before_[next_].second != second)
      return nullptr;
    return &before_[next_++].springs;
  }

  /// After the last meet(): what touched before the evaluation and does no more, by rising (first, second).
  const std::vector<Memory>& parted() {
    parted_.insert(parted_.end(), before_.begin() + static_cast<std::ptrdiff_t>(next_), before_.end());
    next_ = before_.size();
    return parted_;
  }

  void keep(std::int32_t first, std::int32_t second, const ContactSprings& springs) {
    now_.push_back({first, second, springs});
  }

  /// Particle i becomes `place[i]`. What is displaced one way from the first to the second is displaced the
  /// other way from the second to the first.
  void renumber(const std::vector<std::int32_t>& place);

  const std::vector<Memory>& memories() const { return now_; }

 private:
  static bool precedes(const Memory& memory, std::int32_t first, std::int32_t second) {
    return memory.first != first ? memory.first < first : memory.second < second;
  }

  std::vector<Memory> before_, now_, parted_;
  std::size_t next_ = 0;
  double elapsed_ = 0.0;
};

}  // namespace grainproof::reference
