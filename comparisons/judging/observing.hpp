// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "comparisons/judging/exact.hpp"

namespace grainproof {

/// Runs the engine once over every scene that a claim needs, some scenes at a time so that memory
/// stays bounded, and fills the claims' findings. Returns the precision that the engine states.
std::string observe_claims(const Case& subject, Engine& engine, std::vector<Claim>& claims, Records& records,
                           const Progress& progress);

}  // namespace grainproof
