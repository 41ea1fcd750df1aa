// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "comparisons/judging/claims.hpp"

namespace grainproof {

/// Runs the searches that claims ask for, each quantity once a scene, and fills their findings.
/// Returns the precision that the engine states; empty without a search.
std::string search_claims(const Case& subject, Engine& engine, std::vector<Claim>& claims);

}  // namespace grainproof
