// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

#include "comparisons/measured.hpp"
#include "model/observations.hpp"
#include "model/scene.hpp"

/// Of bodies that turn, and of what walls do to them.
namespace grainproof {

/// Size of the first moving particle's angular velocity in the last frame, rad/s.
Measured final_spin(const Scene& scene, const Observations& seen);

/// Largest angle between the two sides' orientations of a particle over all frames, rad. Never negative.
Measured orientation_error(const Scene& scene, const Observations& seen, const Observations& exact);

/// Size of the impulse, N s, that one wall gave the particles.
Measured wall_impulse_of(const Observations& seen, std::size_t wall);

/// Size of its moment about the wall's reference point, N m s.
Measured wall_angular_impulse_of(const Observations& seen, std::size_t wall);

/// Done by moving walls, J.
Measured wall_work(const Scene& scene, const Observations& seen);

template <std::size_t wall>
Measured wall_impulse(const Scene&, const Observations& seen) {
  return wall_impulse_of(seen, wall);
}

template <std::size_t wall>
Measured wall_angular_impulse(const Scene&, const Observations& seen) {
  return wall_angular_impulse_of(seen, wall);
}

}  // namespace grainproof
