// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include "app/bench_session.hpp"

namespace grainproof::app {

/// Long runs of every scene with the integrators that they are asked of.
void measure_long(BenchSession& session);

/// Says in each row that has a bound whether it was held.
void add_verdicts(nlohmann::json& rows);

}  // namespace grainproof::app
