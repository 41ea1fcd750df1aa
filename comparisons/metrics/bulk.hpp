// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "comparisons/measured.hpp"
#include "model/observations.hpp"
#include "model/scene.hpp"

/// Statistics of many bodies, from frames and the scene alone, so the same for every engine.
namespace grainproof {

/// Of translation and rotation, averaged over the frames, J.
Measured mean_kinetic_energy(const Scene& scene, const Observations& seen);

/// Share of solid volume, spheres cut by its faces, in one third of the bed's height (bed_height), from
/// below, in the last frame. The bed fills the domain sideways; gravity is along an axis.
Measured packing_of(const Scene& scene, const Observations& seen, int third);

template <int third>
Measured packing_of_third(const Scene& scene, const Observations& seen) {
  return packing_of(scene, seen, third);
}

/// Elastic part of the normal force, N: mean over the contacts of the second half of the frames, walls
/// included.
Measured contact_force(const Scene& scene, const Observations& seen);

/// Its standard deviation over its mean.
Measured contact_force_spread(const Scene& scene, const Observations& seen);

/// Mass that goes below the lowest rectangle across gravity, kg/s: slope of the line through those frames
/// at which between 5 and 60 per cent of all mass is there.
Measured discharge_rate(const Scene& scene, const Observations& seen);

/// Angle between gravity and the way from a cylinder's axis to the centre of mass, seen along the axis,
/// averaged over the second half of the frames, rad: the slope of a bed in a turning drum.
Measured slope_angle(const Scene& scene, const Observations& seen);

}  // namespace grainproof
