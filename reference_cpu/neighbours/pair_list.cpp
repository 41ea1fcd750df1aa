// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/neighbours/pair_list.hpp"

#include <algorithm>
#include <numeric>

namespace grainproof::reference {

void PairList::begin(std::size_t particles) {
  starts_.clear();
  starts_.reserve(particles + 1);
  starts_.push_back(0);
  partners_.clear();
}

void PairList::assign(std::size_t particles, std::span<const Pair> pairs) {
  starts_.assign(particles + 1, 0);
  for (const auto& [low, high] : pairs) ++starts_[low + 1];
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  partners_.resize(pairs.size());
  filled_.assign(starts_.begin(), starts_.end() - 1);
  for (const auto& [low, high] : pairs) partners_[filled_[low]++] = high;
  for (std::size_t i = 0; i < particles; ++i)
    std::sort(partners_.begin() + starts_[i], partners_.begin() + starts_[i + 1]);
}

}  // namespace grainproof::reference
