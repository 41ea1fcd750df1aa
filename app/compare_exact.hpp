// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "app/compare.hpp"

namespace grainproof::app {

/// Runs a scene on two engines, or two scenes of the same particles on one, and shows the first step at which
/// a bit of their states differs, and whose it is. Returns all_held where none does, else verdict_failed.
int compare_exact(const CompareOptions& options, Terminal& terminal);

}  // namespace grainproof::app
