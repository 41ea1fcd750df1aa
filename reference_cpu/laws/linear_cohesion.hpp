// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grainproof::reference {

/// Attraction between effect surfaces (docs/laws/cohesion.md; Andrews 2.6 with the sign of E7).
struct EffectSpring {
  double stiffness = 0.0;  ///< k_c, N/m; zero is no cohesion

  /// Along n, on body 2: negative, also while the bodies touch.
  double force(double effect_overlap) const { return -stiffness * effect_overlap; }

  double potential(double effect_overlap) const { return -0.5 * stiffness * effect_overlap * effect_overlap; }
};

}  // namespace grainproof::reference
