// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>

#include "comparisons/measured.hpp"
#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof {

/// The later frames, at least the last.
std::span<const Frame> second_half(const Observations& seen);

/// Against gravity; z where there is none.
Vec3 up(const Scene& scene);

/// Height of the lowest corner of the domain.
double floor_of(const Domain& domain, const Vec3& upwards);

/// Twice the mean height of the particles above the lowest corner of the domain, in the last frame, m: the
/// height of a uniform bed with that centre.
Measured bed_height(const Scene& scene, const Observations& seen);

/// Particles that a particle overlaps, on average, in the last frame.
Measured contact_number(const Scene& scene, const Observations& seen);

/// The same over the second half of the frames: of bodies that never come to rest.
Measured mean_contact_number(const Scene& scene, const Observations& seen);

}  // namespace grainproof
