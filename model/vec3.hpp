// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Geometry>

namespace grainproof {

/// A vector in the scene's Cartesian frame, SI units.
using Vec3 = Eigen::Vector3d;

/// A turn from a body's own frame into the scene's.
using Quaternion = Eigen::Quaterniond;

}  // namespace grainproof
