// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/bench_sample.hpp"

/// What error costs: from the points of `bench accuracy`.
namespace grainproof::app {

/// One point of a curve of one code on one scene.
struct WorkPoint {
  double error;
  double wall_s;
  double steps_per_contact;
};

/// Time at which a curve reaches `error`, between the two points that enclose it, both logarithmic. The time
/// of the coarsest point where that is accurate enough already; nothing where no point is.
std::optional<WorkPoint> interpolated_at(std::vector<WorkPoint> curve, double error);

/// Rows {"scene": "pair_gas", engine, precision, integrator, "error", "wall_s", "steps_per_contact"}: what a
/// curve takes to reach `error`, the median over rounds; where it is not reached, "wall_s" is null.
nlohmann::json times_to_error(const std::vector<Sample>& samples, double error);

/// The least time of a peer to `error` over the least of each of our engines, round by round.
nlohmann::json ratios_to_error(const std::vector<Sample>& samples, double error);

/// Rows of the suite that did not come to an end or are not stable, and what no engine could run.
nlohmann::json failed_points(const nlohmann::json& rows);

/// A measured order for each row but the coarsest of its curve: "order", from the next coarser step.
void add_local_orders(nlohmann::json& rows);

}  // namespace grainproof::app
