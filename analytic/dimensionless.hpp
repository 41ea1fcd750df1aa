// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Numbers that say in which regime a flow or a collision is; docs/laws/fields.md and cohesion.md.
namespace grainproof::analytic {

/// ρ d² u/(18 μ_f L) (fields.7).
double stokes_number(double density, double diameter, double viscosity, double speed, double length);

/// Mean of |u| over a Taylor-Green vortex for amplitude 1 (fields.9): 0.77994, not 0.7839 (E10).
double taylor_green_mean_speed();

/// The source's Sy (cohesion.7): above 1 it expects a collision to stick; not exact (E6).
double stickiness_number(double reach, double cohesion_stiffness, double restitution, double speed,
                         double mass);

/// The speed at which Sy is 1; infinity for restitution 0.
double sticking_speed_of_source(double reach, double cohesion_stiffness, double restitution, double mass);

}  // namespace grainproof::analytic
