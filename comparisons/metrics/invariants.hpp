// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "comparisons/measured.hpp"
#include "model/observations.hpp"
#include "model/scene.hpp"

/// What must hold whatever the exact solution is; `exact` is not looked at.
namespace grainproof {

/// Change of Σ m v less the impulses of supports and fields, relative to all momentum that the run
/// had or was given: largest Σ m |v| of a frame plus the impulses' sizes. Never negative.
Measured momentum_error(const Scene& scene, const Observations& seen, const Observations& exact);

/// Change of Σ (m x × v + I ω) about the origin less the moments that still walls gave, relative to the sizes
/// of the terms. Never negative; only where nothing else acts from outside.
Measured angular_momentum_error(const Scene& scene, const Observations& seen, const Observations& exact);

/// Drift of the ledger's balance relative to the largest entry of the ledger.
Measured energy_error(const Scene& scene, const Observations& seen, const Observations& exact);

/// Fraction of particles that some frame lacks, or has outside a face that is not periodic.
Measured lost_particles(const Scene& scene, const Observations& seen, const Observations& exact);

}  // namespace grainproof
