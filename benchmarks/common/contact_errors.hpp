// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "analytic/measured_errors.hpp"

namespace grainproof::bench {

/// What the reference engine's error is now, as analytic::MeasuredErrors has it: contacts of usual spheres,
/// five per cent about the usual diameter, at speeds of 0.5 to 1.5 m/s, and of history friction from every
/// angle, µ 0.5, k_t 2/7 of k_n. At most 1, which also stands for a run that did not come to its end.
double contact_error(analytic::ErrorLaw law, Integrator integrator, double restitution, double steps);

/// Whether the reference engine can run that at all.
bool can_be_measured(analytic::ErrorLaw law, Integrator integrator);

}  // namespace grainproof::bench
