// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof::app {

/// Looks now and then whether kinetic energy has come from nowhere: whether, between two looks, it has grown
/// by more than there was of energy and than gravity, walls, fluid and springs have turned over. An explicit
/// scheme beyond its stable step does that within a few steps; a sound one with many steps a contact errs by
/// per cents.
///
/// With a ledger every source is known. Without, gravity is told from the positions and springs from the
/// overlaps at the look before; a scene with moving walls, a fluid, cohesion or gravity that is not constant
/// is then not looked at.
class EnergySentinel {
 public:
  explicit EnergySentinel(const Scene& scene);

  /// Throws RunWentWrong where energy has come from nowhere since the look before. `ledger` may be null.
  void look(const Frame& frame, const Ledger* ledger);

  /// Step of the last look that found nothing wrong; −1 before the first.
  std::int64_t last_good_step() const { return frame_ ? frame_->step : -1; }

  /// What may be gained between two looks, as a share of what there was and was turned over.
  static constexpr double limit = 1.0;

 private:
  void look_with(const Frame& frame, const Ledger& ledger);
  void look_without(const Frame& frame);
  [[noreturn]] void tell(const Frame& frame, double before, double now, double gained, double allowed) const;

  const Scene& scene_;
  bool told_by_positions_;
  std::optional<Frame> frame_;
  std::optional<Ledger> ledger_;
};

}  // namespace grainproof::app
