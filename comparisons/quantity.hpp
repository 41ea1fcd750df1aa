// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "comparisons/measured.hpp"
#include "comparisons/searches/searches.hpp"
#include "model/engine.hpp"

namespace grainproof {

/// One thing that a case can make a claim about. Errors are signed and relative.
struct Quantity {
  using Compare = Measured (*)(const Scene& scene, const Observations& seen, const Observations& exact);
  using Value = Measured (*)(const Scene& scene, const Observations& seen);
  /// One value a scene, found by running the engine many times.
  using Search = std::vector<Found> (*)(std::span<const Scene> scenes, Engine& engine,
                                        std::span<const double> hints);

  std::string_view name;
  std::string_view relative_to;  ///< the scale of the error, in words
  Value value = nullptr;         ///< of a single number; a band is judged over such only
  Compare compare = nullptr;     ///< where it is more than a number, or held against no other
  Search search = nullptr;       ///< where the number takes many runs
  bool every_step = false;       ///< needs a frame at every step
  bool ledger = false;           ///< needs the ledger
  bool curve = false;            ///< needs the exact solution at the frames' own times
  double zero_scale = 0.0;       ///< scale of the error where the exact value is zero; 0 is none

  Request request() const { return {{}, every_step, ledger}; }

  /// Of what is not searched.
  Measured error(const Scene& scene, const Observations& seen, const Observations& exact) const;

  /// What the exact side says by name, or else what its frames say.
  Measured exact_value(const Scene& scene, const Observations& exact) const;
};

std::span<const Quantity> quantities();

/// Null where there is none of that name.
const Quantity* quantity_named(std::string_view name);

/// (seen − exact)/|exact|. An exact zero has the scale `zero_scale`; 0 there means it has none.
Measured relative_error(const Measured& seen, const Measured& exact, double zero_scale = 0.0);

}  // namespace grainproof
