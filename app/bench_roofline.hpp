// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include "app/bench_session.hpp"

namespace grainproof::app {

/// Measures what the device can do at best, for every number of threads.
void measure_roofline(BenchSession& session);

/// To rows that tell pairs and speed: bytes and floating-point operations that a particle-step cannot do
/// without (docs/benchmarks.md), and the shares of the device's rates that they make.
void add_shares(nlohmann::json& rows);

}  // namespace grainproof::app
