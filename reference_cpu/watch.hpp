// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>

#include "model/errors.hpp"
#include "model/scene.hpp"

namespace grainproof::reference {

/// What went wrong first, by indices; told in words only when it is raised.
struct Trouble {
  enum class Kind { not_finite, escaped, leapt, pair_too_deep, wall_too_deep } kind;
  std::int32_t particle;
  std::int32_t partner = -1;  ///< particle or wall
  double overlap = 0.0;       ///< m
};

/// Collects trouble out of hot loops. The first one stands.
class Watch {
 public:
  explicit Watch(double overlap_limit) : overlap_limit_(overlap_limit) {}

  /// Share of the smaller radius beyond which an overlap is trouble.
  double overlap_limit() const { return overlap_limit_; }

  void report(const Trouble& trouble) {
    if (!trouble_) trouble_ = trouble;
  }

  const std::optional<Trouble>& trouble() const { return trouble_; }

 private:
  double overlap_limit_;
  std::optional<Trouble> trouble_;
};

/// Cause, particles, numbers and the likely reason, for people. The particles are the scene's.
RunWentWrong in_words(const Trouble& trouble, const Scene& scene, std::int64_t step, double overlap_limit);

}  // namespace grainproof::reference
