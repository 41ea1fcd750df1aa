// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "report/claims.hpp"
#include "report/plot.hpp"

namespace grainproof::report {

/// Error against step for one claim of a case: what was judged at each step, and the further points that
/// an order was fitted to. Steps written as "contact/64" are drawn as that fraction, seconds as seconds.
Plot convergence_plot(const std::string& case_name, const Claim& claim);

}  // namespace grainproof::report
