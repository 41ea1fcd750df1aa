// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

#include "model/scene.hpp"

namespace grainproof::opencl {

/// Finds the skin with which steps and lists together are least work. Work is counted, never timed, so that
/// the same scene takes the same skins on any machine, at any load.
///
/// A step costs one for each entry of the list, a list as much as `list_entries` of them; a list lasts in
/// proportion to its skin.
class SkinSearch {
 public:
  /// Diameters: lists beyond are looked for in other cells, and places would have other bits.
  static constexpr double widest = 0.3;

  SkinSearch() = default;
  /// Never below `least`: some integrators need a part of it.
  SkinSearch(double diameter, double first, double least = 0.0)
      : diameter_(diameter), least_(least), skin_(first) {}

  double skin() const { return skin_; }

  /// A list of this skin had so many entries a particle and has lasted so long. Whether another is better by
  /// far, which is then the new one; but for the first few lists, seldom asked.
  bool learn(double entries, std::int64_t steps);

  /// The age, above `age`, at which even a list that holds is to be learnt from.
  static std::int64_t next_trial(std::int64_t age);

 private:
  double entries_at(double skin) const;

  double diameter_ = 0.0, least_ = 0.0, skin_ = 0.0;
  double entries_ = 0.0;
  double other_skin_ = -1.0, other_entries_ = 0.0;  ///< of the last list of another skin
  std::int64_t lists_ = 0;
};

/// From the highest speed at the start; a tenth of a diameter where nothing moves.
double first_skin(const Scene& scene);

}  // namespace grainproof::opencl
