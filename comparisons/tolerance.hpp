// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grainproof {

/// A case's own bound plus the round-off floor: `ulps` unit round-offs of the engine's precision and
/// of the precision that it is held against. A closed form has none. So no bar is below what a
/// format can hold, and a bound of zero asks for round-off only.
constexpr double round_off_floor(double ulps, double unit_roundoff) {
  return ulps * unit_roundoff;
}

constexpr double tolerance(double below, double ulps, double unit_roundoff) {
  return below + round_off_floor(ulps, unit_roundoff);
}

/// NaN on either side fails.
constexpr bool within(double error, double bar) {
  return (error < 0.0 ? -error : error) <= bar;
}

}  // namespace grainproof
