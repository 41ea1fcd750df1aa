// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "comparisons/measured.hpp"
#include "model/observations.hpp"
#include "model/scene.hpp"

/// Numbers that describe one run, from its frames alone.
namespace grainproof {

/// −(normal speed at the end)/(normal speed at the start) of the pair that meets first, along the
/// normal at which they meet. From the first and the last frame.
Measured restitution(const Scene& scene, const Observations& seen);

/// By how much the collision slows the tangential slip, m/s: first and last frame, same normal. Of bodies
/// that turn, the slip of their surfaces.
Measured tangential_velocity_change(const Scene& scene, const Observations& seen);

/// From the first touch to the first parting, s. Needs every step. The paths outside the contact are
/// straight to the second order in the step, so both ends are found by straight flight.
Measured contact_duration(const Scene& scene, const Observations& seen);

/// Deepest overlap of the first contact, m. Needs every step; cubic Hermite between frames, which is
/// of fourth order in the step.
Measured peak_overlap(const Scene& scene, const Observations& seen);

}  // namespace grainproof
