// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/laws.hpp"
#include "model/vec3.hpp"

namespace grainproof::reference {

/// Rolling resistance of one pair of materials (docs/laws/rolling.md).
struct RollingResistance {
  double coefficient = 0.0;  ///< zero is no rolling resistance
  bool spring = false;       ///< elastic up to its limit; else the torque is always at it

  bool present() const { return coefficient != 0.0; }
};

RollingResistance rolling_resistance(const RollingLaw& law);

/// On body 2, N m: `most` against the spin of body 2 over body 1, then without its part along n, so that a
/// spin about n makes it smaller.
Vec3 constant_torque(double most, const Vec3& spin, const Vec3& normal);

/// On body 2, N m: the torque that is kept, as it stands in space, wound against the spin and cut back to
/// `most`. `stiffness` in N m/rad.
Vec3 wound_torque(const Vec3& kept, double most, double stiffness, const Vec3& spin, const Vec3& normal,
                  double elapsed);

}  // namespace grainproof::reference
