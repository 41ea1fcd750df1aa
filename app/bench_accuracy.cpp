// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "app/bench_suites.hpp"
#include "app/bench_work_precision.hpp"

namespace grainproof::app {
namespace {

using nlohmann::json;

constexpr double error_that_counts = 1e-3;  // of the pair gas, whose time is compared
constexpr double known_within = 0.05;       // of the errors that the peers are known to make

bool is_known(const json& row) {
  return row.at("scene").get<std::string>().starts_with("known_");
}

/// An error that hardly exceeds that of the solution it is taken against says nothing of the order.
bool is_sharp(const json& row) {
  return row.at("error").get<double>() > 3.0 * row.value("uncertainty", 0.0);
}

struct Curve {
  json first;                                     ///< one of its rows
  std::vector<std::pair<double, double>> points;  ///< step and error
};

/// Slope of log error against log step, by least squares.
double order_of(const Curve& curve) {
  const auto count = static_cast<double>(curve.points.size());
  double x_sum = 0.0, y_sum = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [step, error] : curve.points) {
    const double x = std::log(step), y = std::log(error);
    x_sum += x;
    y_sum += y;
    xx += x * x;
    xy += x * y;
  }
  return (count * xy - x_sum * y_sum) / (count * xx - x_sum * x_sum);
}

void add_orders(BenchSession& session, const std::vector<json>& rows) {
  std::map<std::vector<std::string>, Curve> curves;
  const std::vector<std::string> keys{"scene", "engine", "precision", "integrator"};
  for (const json& row : rows) {
    std::vector<std::string> who;
    if (is_known(row) || !is_sharp(row)) continue;
    for (const std::string& key : keys) who.push_back(row.at(key).get<std::string>());
    Curve& curve = curves[who];
    curve.first = row;
    curve.points.emplace_back(row.at("step").get<double>(), row.at("error").get<double>());
  }
  for (const auto& [who, curve] : curves) {
    if (curve.points.size() < 2) continue;
    json order{{"suite", "accuracy"}, {"order", order_of(curve)}};
    for (const std::string& key : keys) order[key] = curve.first.at(key);
    session.extra["orders"].push_back(std::move(order));
  }
}

/// Ours are one: what counts is what the program can do.
std::string side_of(const json& row) {
  const std::string engine = row.at("engine").get<std::string>();
  return engine == "lammps" || engine == "liggghts" ? engine : "ours";
}

/// For each scene and side, and each decade of error: the least time of a point at least that accurate.
void add_decades(BenchSession& session, const std::vector<json>& rows) {
  std::map<std::pair<std::string, std::string>, std::map<int, const json*>> best;
  for (const json& row : rows) {
    if (is_known(row)) continue;
    for (int decade = -1; std::pow(10.0, decade) >= row.at("error").get<double>(); --decade) {
      const json*& cheapest = best[{row.at("scene").get<std::string>(), side_of(row)}][decade];
      if (!cheapest || row.at("wall_s") < cheapest->at("wall_s")) cheapest = &row;
    }
  }
  for (const auto& [who, decades] : best)
    for (const auto& [decade, row] : decades) {
      json found{{"suite", "accuracy"}, {"side", who.second}, {"decade", decade}};
      found["error"] = std::pow(10.0, decade);
      for (const char* key : {"scene", "engine", "precision", "integrator", "steps_per_contact", "wall_s"})
        found[key] = row->at(key);
      session.extra["decades"].push_back(std::move(found));
    }
}

/// The table of errors that the peers once made, held against what was run live.
void add_known(BenchSession& session, const std::vector<json>& rows) {
  std::map<std::string, double> worst;
  for (const json& row : rows)
    if (is_known(row)) {
      const double away = std::abs(row.at("error").get<double>() / row.at("known_error").get<double>() - 1.0);
      double& most = worst[row.at("engine").get<std::string>()];
      most = std::max(most, away);
    }
  for (const auto& [engine, away] : worst)
    session.extra["known_errors"].push_back({{"suite", "accuracy"},
                                             {"engine", engine},
                                             {"largest_deviation", away},
                                             {"allowed", known_within},
                                             {"reproduced", away <= known_within}});
}

}  // namespace

void conclude_accuracy(BenchSession& session) {
  std::vector<json> rows;
  for (const json& row : rows_of(session.all()))
    if (row.at("suite") == "accuracy" && row.at("status") == "completed" &&
        row.at("error").get<double>() > 0.0)
      rows.push_back(row);
  add_orders(session, rows);
  add_decades(session, rows);
  add_known(session, rows);
  session.extra["times_to_error"] = times_to_error(session.all(), error_that_counts);
  for (json& ratio : ratios_to_error(session.all(), error_that_counts))
    session.extra["ratios"].push_back(std::move(ratio));
  session.extra["failed"] = failed_points(rows_of(session.all()));
}

}  // namespace grainproof::app
