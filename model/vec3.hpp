// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace grainproof {

/// A vector in the scene's Cartesian frame, SI units.
using Vec3 = Eigen::Vector3d;

}  // namespace grainproof
