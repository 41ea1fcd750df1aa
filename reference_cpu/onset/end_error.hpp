// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grainproof::reference {

/// Hurwitz' ζ(−exponent, first), for 0 ≤ exponent and 0 ≤ first ≤ 1: what the sum over j of (first +
/// j)^exponent is more than its integral from 0. So it is the error of the trapezoid rule for a power that
/// begins or ends within a step (docs/laws/integrators.md).
double hurwitz(double exponent, double first);

}  // namespace grainproof::reference
