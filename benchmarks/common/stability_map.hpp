// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "benchmarks/common/stability_cases.hpp"

namespace grainproof::bench {

/// Every point of the map of stable steps: arrangement, damping, masses, stiffnesses, friction.
std::vector<StabilityCase> stability_map(bool quick);

/// What another engine than the reference is asked for: the laws and arrangements, not every number.
bool is_representative(const StabilityCase& one, bool quick);

/// About how long a row takes on an engine against others, for the time that is still to go.
double weight_of(const StabilityCase& one, const std::string& engine);

/// "scene:chain/ENGINE/integrator:…/restitution:…/…", with `engine` and `integrator` as a row names them.
std::string name_of(const StabilityCase& one, const std::string& engine, const std::string& integrator);

}  // namespace grainproof::bench
