// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "model/scene.hpp"

namespace grainproof {

/// A position put into the domain along its periodic axes, as frames want it.
inline Vec3 folded(Vec3 x, const Domain& domain) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain.periodic(axis)) continue;
    const double length = domain.extent()[axis];
    x[axis] -= length * std::floor((x[axis] - domain.lower[axis]) / length);
    if (x[axis] >= domain.upper[axis]) x[axis] = domain.lower[axis];  // rounded up to the far face
  }
  return x;
}

}  // namespace grainproof
