// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace grainproof::reference {

/// What is remembered of bodies that touch, from one evaluation of the forces to the next. A Memory names the
/// two: `first`, a particle, or for a wall its index after the particles, and `second`, a particle.
/// Contacts are gone through by rising (first, second), whoever found them, so the memory of one is
/// met by going along those of the evaluation before: it hangs on no list, and none that is rebuilt
/// can lose it. What is not kept has parted and is forgotten.
template <class Memory>
class ContactWalk {
 public:
  /// What contacts remember before the first evaluation, by rising (first, second).
  explicit ContactWalk(std::vector<Memory> remembered) : now_(std::move(remembered)) {}

  /// Starts an evaluation.
  void begin() {
    before_.swap(now_);
    now_.clear();
    parted_.clear();
    next_ = 0;
  }

  /// Null for bodies that did not touch before. To be asked by rising (first, second).
  const Memory* meet(std::int32_t first, std::int32_t second) {
    if (next_ == before_.size()) return nullptr;
    if (!is_between(before_[next_], first, second)) [[unlikely]]
      if (!leads_to(first, second)) return nullptr;
    return &before_[next_++];
  }

  /// After the last meet(): what touched before the evaluation and does no more, by rising (first, second).
  const std::vector<Memory>& parted() {
    parted_.insert(parted_.end(), before_.begin() + static_cast<std::ptrdiff_t>(next_), before_.end());
    next_ = before_.size();
    return parted_;
  }

  void keep(const Memory& memory) { now_.push_back(memory); }

  /// Particle i becomes `place[i]`; `turn` is told whose first and second have changed places.
  template <class Turn>
  void renumber(const std::vector<std::int32_t>& place, Turn turn) {
    const auto particles = static_cast<std::int32_t>(place.size());
    for (Memory& memory : now_) {
      memory.second = place[memory.second];
      if (memory.first >= particles) continue;
      memory.first = place[memory.first];
      if (memory.first < memory.second) continue;
      std::swap(memory.first, memory.second);
      turn(memory);
    }
    std::ranges::sort(now_, {}, [](const Memory& memory) { return std::tuple(memory.first, memory.second); });
  }

  const std::vector<Memory>& memories() const { return now_; }

 private:
  static bool is_between(const Memory& memory, std::int32_t first, std::int32_t second) {
    return memory.first == first && memory.second == second;
  }

  /// Goes past those that have parted. Rare, and kept out of the loops that are flattened.
  [[gnu::noinline]] bool leads_to(std::int32_t first, std::int32_t second) {
    const auto precedes = [&](const Memory& memory) {
      return memory.first != first ? memory.first < first : memory.second < second;
    };
    while (next_ < before_.size() && precedes(before_[next_])) parted_.push_back(before_[next_++]);
    return next_ < before_.size() && is_between(before_[next_], first, second);
  }

  std::vector<Memory> before_, now_, parted_;
  std::size_t next_ = 0;
};

}  // namespace grainproof::reference
