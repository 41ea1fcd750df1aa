// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/contact_history.hpp"

namespace grainproof::reference {

/// ContactHistory for contacts of which nothing is known but that they touch: a ninth of its size.
class Touching {
 public:
  struct Memory {
    std::int32_t first;   ///< particle; for a wall its index after the particles
    std::int32_t second;  ///< particle
  };

  Touching() = default;
  explicit Touching(std::vector<Memory> now) : now_(std::move(now)) {}

  void begin() {
    before_.swap(now_);
    now_.clear();
    parted_.clear();
    next_ = 0;
  }

  /// Null for bodies that did not touch before. To be asked by rising (first, second).
  const ContactSprings* meet(std::int32_t first, std::int32_t second) {
    while (next_ < before_.size() && precedes(before_[next_], first, second))
      parted_.push_back(before_[next_++]);
    if (next_ == before_.size() || before_[next_].first != first || before_[next_].second != second)
      return nullptr;
    ++next_;
    return &at_rest_;
  }

  void keep(std::int32_t first, std::int32_t second, const ContactSprings&) {
    now_.push_back({first, second});
  }

  /// After the last meet(): what touched before and does no more.
  const std::vector<Memory>& parted() {
    parted_.insert(parted_.end(), before_.begin() + static_cast<std::ptrdiff_t>(next_), before_.end());
    next_ = before_.size();
    return parted_;
  }

  /// Particle i becomes `place[i]`.
  void renumber(const std::vector<std::int32_t>& place);

  const std::vector<Memory>& memories() const { return now_; }

 private:
  static bool precedes(const Memory& memory, std::int32_t first, std::int32_t second) {
    return memory.first != first ? memory.first < first : memory.second < second;
  }

  std::vector<Memory> before_, now_, parted_;
  std::size_t next_ = 0;
  ContactSprings at_rest_;
};

}  // namespace grainproof::reference
