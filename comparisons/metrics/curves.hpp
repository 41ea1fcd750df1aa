// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "comparisons/measured.hpp"
#include "model/observations.hpp"
#include "model/scene.hpp"

/// Errors of whole runs, frame by frame; both sides must have the same frames. The sign says whether
/// the run is ahead of the exact one (too far, too fast) where it is most wrong.
namespace grainproof {

/// Of translation and, where there is one, rotation, J.
double kinetic_energy(const Scene& scene, const Frame& frame);

/// Largest distance from the exact place over frames and particles, relative to the longest path a
/// particle has in the exact solution.
Measured position_error(const Scene& scene, const Observations& seen, const Observations& exact);

/// Largest velocity error over frames and particles, relative to the largest exact speed.
Measured velocity_error(const Scene& scene, const Observations& seen, const Observations& exact);

/// Largest error of an angular velocity over frames and particles, relative to the largest exact one, or
/// to the largest exact speed over radius where nothing turns.
Measured angular_velocity_error(const Scene& scene, const Observations& seen, const Observations& exact);

/// Translation and, where there is one, rotation. Root mean square over the frames of the kinetic energy's
/// error, relative to its largest value.
Measured kinetic_energy_error(const Scene& scene, const Observations& seen, const Observations& exact);

}  // namespace grainproof
