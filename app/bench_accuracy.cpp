// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "app/bench_suites.hpp"

namespace grainproof::app {
namespace {

using nlohmann::json;

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

/// For each scene and engine, and each decade of error: the least time of a point at least that accurate.
void add_decades(BenchSession& session, const std::vector<json>& rows) {
  std::map<std::string, std::map<int, const json*>> best;
  for (const json& row : rows) {
    const std::string who = row.at("scene").get<std::string>() + ", " + row.at("engine").get<std::string>() +
                            " " + row.at("precision").get<std::string>();
    for (int decade = -1; std::pow(10.0, decade) >= row.at("error").get<double>(); --decade) {
      const json*& cheapest = best[who][decade];
      if (!cheapest || row.at("wall_s") < cheapest->at("wall_s")) cheapest = &row;
    }
  }
  for (const auto& [who, decades] : best)
    for (const auto& [decade, row] : decades)
      session.extra["decades"].push_back({{"suite", "accuracy"},
                                          {"who", who},
                                          {"error", std::pow(10.0, decade)},
                                          {"wall_s", row->at("wall_s")},
                                          {"integrator", row->at("integrator")},
                                          {"steps_per_contact", row->at("steps_per_contact")}});
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
}

}  // namespace grainproof::app
