// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "analytic/encounter.hpp"

/// A sphere that turns against a wall, or a fixed sphere: docs/laws/rotation.md.
namespace grainproof::analytic {

/// The slip of a sphere on a wall, spin included, with the radius as its torque arm (rotation.2).
Vec3 slip_of(const Scene& scene, const Encounter& encounter);

/// The sphere when its gap is this and friction has taken `lost` off its velocity, having run `path`
/// along the wall (rotation.4).
Frame frame_of_sphere(const Scene& scene, const Encounter& encounter, const Motion& gap, const Vec3& path,
                      const Vec3& lost, double time);

/// Coulomb's coefficient, and the stiffness of the spring; infinite where friction has none.
struct Rub {
  double coefficient;
  double stiffness;
};

/// Dynamic friction, or an undamped spring with arm r, at this overlap. `why_not_turning` says why not.
Rub rub_of(const Scene& scene, const Encounter& encounter, double overlap);
std::string why_not_turning(const Scene& scene, const Encounter& encounter);

}  // namespace grainproof::analytic
