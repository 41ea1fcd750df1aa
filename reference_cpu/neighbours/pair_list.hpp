// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "model/sections.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/periodic_box.hpp"

namespace grainproof::reference {

/// Half list: every pair once, under its lower index, partners rising. Going through it from the
/// front meets the partners of any one particle in rising order, so the order in which its contacts
/// are summed is the same however the pairs were found.
class PairList {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;  ///< lower index first

  /// Starts an empty list whose pairs are appended in order: all of particle 0, all of 1, …
  void begin(std::size_t particles);
  void append_partner(std::int32_t partner) { partners_.push_back(partner); }
  void end_particle() { starts_.push_back(static_cast<std::int32_t>(partners_.size())); }

  /// From pairs in any order, each once.
  void assign(std::size_t particles, std::span<const Pair> pairs);

  /// Pairs of particle i, among all partners.
  std::int32_t first(std::size_t particle) const { return starts_[particle]; }
  std::int32_t last(std::size_t particle) const { return starts_[particle + 1]; }
  std::int32_t partner(std::int32_t pair) const { return partners_[pair]; }
  std::size_t size() const { return partners_.size(); }

  void pack_into(Sections& own) const {
    pack(own, "pairs.starts", starts_);
    pack(own, "pairs.partners", partners_);
  }
  void unpack_from(const Sections& own) {
    unpack(own, "pairs.starts", starts_);
    unpack(own, "pairs.partners", partners_);
  }

 private:
  std::vector<std::int32_t> starts_;
  std::vector<std::int32_t> partners_;
  std::vector<std::int32_t> filled_;
};

/// Whether a pair belongs on a list: close enough to touch before both have moved half the skin, and
/// not both fixed. The last factor keeps round-off of a distance from ever hiding a contact.
inline bool belongs(const Bodies& bodies, const PeriodicBox& box, double skin, std::int32_t i,
                    std::int32_t j) {
  const Body& one = bodies.body[i];
  const Body& two = bodies.body[j];
  if (one.fixed() && two.fixed()) return false;
  const double range = (bodies.reach[i] + bodies.reach[j] + skin) * (1.0 + 1e-12);
  return box.nearest_image(two.position - one.position).squaredNorm() < range * range;
}

}  // namespace grainproof::reference
