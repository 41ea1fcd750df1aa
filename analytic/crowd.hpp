// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"

namespace grainproof::analytic {

/// Upper bounds on the contacts that one body can have at once, with normals n of unit length.
struct Crowd {
  double contacts;   ///< how many
  double along;      ///< Σ (n·e)² for any direction e
  double across;     ///< Σ 1 − (n·e)², likewise
  double resultant;  ///< |Σ n|

  bool alone() const { return contacts <= 1.0; }
};

/// Of a sphere of this diameter in the scene, however the others come to lie (docs/stability.md): all the
/// other particles, as far as they find room about it, and every wall that it can touch together with them.
Crowd crowd_of(const Scene& scene, double diameter);

}  // namespace grainproof::analytic
