// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_work_precision.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace grainproof::app {
namespace {

using nlohmann::json;

const std::string scene_that_counts = "pair_gas";

bool is_peer(const std::string& engine) {
  return engine == "lammps" || engine == "liggghts";
}

/// Engine and precision, then integrator, then round.
using Curves = std::map<std::string, std::map<std::string, std::map<int, std::vector<WorkPoint>>>>;

Curves curves_of(const std::vector<Sample>& samples) {
  Curves curves;
  for (const Sample& sample : samples)
    if (sample.key("suite") == "accuracy" && sample.key("scene") == scene_that_counts && sample.error.empty())
      curves[engine_of(sample)][sample.key("integrator")][sample.round].push_back(
          {sample.value("error"), sample.value("wall_s"), std::stod(sample.key("steps_per_contact"))});
  return curves;
}

/// Of each round, the least time of any integrator.
std::map<int, double> best_times(const Curves::mapped_type& integrators, double error) {
  std::map<int, double> best;
  for (const auto& [integrator, rounds] : integrators)
    for (const auto& [round, curve] : rounds)
      if (const auto reached = interpolated_at(curve, error))
        best[round] = best.contains(round) ? std::min(best[round], reached->wall_s) : reached->wall_s;
  return best;
}

json ratio_row(const std::string& what, const std::map<int, double>& over,
               const std::map<int, double>& under) {
  std::vector<double> found;
  for (const auto& [round, seconds] : over)
    if (under.contains(round)) found.push_back(seconds / under.at(round));
  if (found.empty()) return nullptr;
  const Spread spread = spread_of(found);
  return {{"suite", "accuracy"}, {"scene", scene_that_counts}, {"what", what},      {"rounds", found.size()},
          {"min", spread.least}, {"median", spread.median},    {"max", spread.most}};
}

}  // namespace

std::optional<WorkPoint> interpolated_at(std::vector<WorkPoint> curve, double error) {
  std::sort(curve.begin(), curve.end(), [](const WorkPoint& one, const WorkPoint& other) {
    return one.steps_per_contact < other.steps_per_contact;
  });
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!(curve[i].error <= error)) continue;
    if (i == 0) return curve[0];
    const WorkPoint &coarse = curve[i - 1], &fine = curve[i];
    const double share = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
    const auto between = [share](double one, double other) {
      return std::exp((1.0 - share) * std::log(one) + share * std::log(other));
    };
    return WorkPoint{error, between(coarse.wall_s, fine.wall_s),
                     between(coarse.steps_per_contact, fine.steps_per_contact)};
  }
  return std::nullopt;
}

json times_to_error(const std::vector<Sample>& samples, double error) {
  json rows = json::array();
  for (const auto& [engine, integrators] : curves_of(samples))
    for (const auto& [integrator, rounds] : integrators) {
      std::vector<double> seconds, steps;
      for (const auto& [round, curve] : rounds)
        if (const auto reached = interpolated_at(curve, error)) {
          seconds.push_back(reached->wall_s);
          steps.push_back(reached->steps_per_contact);
        }
      json row{{"suite", "accuracy"}, {"scene", scene_that_counts},
               {"who", engine},       {"integrator", integrator},
               {"error", error},      {"wall_s", nullptr}};
      if (!seconds.empty()) {
        row["wall_s"] = spread_of(seconds).median;
        row["steps_per_contact"] = spread_of(steps).median;
      }
      rows.push_back(std::move(row));
    }
  return rows;
}

json ratios_to_error(const std::vector<Sample>& samples, double error) {
  const Curves curves = curves_of(samples);
  json rows = json::array();
  for (const auto& [ours, own] : curves)
    for (const auto& [peer, theirs] : curves) {
      if (is_peer(ours) || !is_peer(peer)) continue;
      json row = ratio_row("pair gas, time of " + peer + " over that of " + ours + " to an error of 1e-3",
                           best_times(theirs, error), best_times(own, error));
      if (!row.is_null()) rows.push_back(std::move(row));
    }
  return rows;
}

json failed_points(const json& rows) {
  json failed = json::array();
  for (const json& row : rows)
    if (row.at("suite") == "accuracy" && row.at("status") != "completed") failed.push_back(row);
  return failed;
}

void add_local_orders(json& rows) {
  std::map<std::string, std::map<double, json*>> curves;
  for (json& row : rows) {
    if (row.at("suite") != "accuracy" || row.at("status") != "completed") continue;
    std::string who;
    for (const char* key : {"scene", "engine", "precision", "integrator", "restitution"})
      who += row.value(key, json("")).dump() + "/";
    curves[who][row.at("steps_per_contact").get<double>()] = &row;
  }
  for (const auto& [who, points] : curves)
    for (auto coarse = points.begin(), fine = std::next(coarse); fine != points.end(); ++coarse, ++fine) {
      const double from = coarse->second->at("error").get<double>(),
                   to = fine->second->at("error").get<double>();
      if (from > 0.0 && to > 0.0)
        (*fine->second)["order"] = std::log(from / to) / std::log(fine->first / coarse->first);
    }
}

}  // namespace grainproof::app
