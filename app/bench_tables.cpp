// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_tables.hpp"

#include <cmath>
#include <map>
#include <sstream>

#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

using nlohmann::json;

std::string cell(const json& row, const std::string& key) {
  const auto found = row.find(key);
  if (found == row.end() || found->is_null()) return "";
  if (found->is_string()) return found->get<std::string>() == "completed" ? "" : found->get<std::string>();
  if (found->is_number_integer()) return report::grouped(found->get<long long>());
  return report::brief(found->get<double>());
}

bool is_number(const json& rows, const std::string& key) {
  for (const json& row : rows)
    if (row.contains(key)) return row.at(key).is_number();
  return false;
}

json rows_of_suite(const json& results, const std::string& list, const std::string& suite) {
  json rows = json::array();
  if (results.contains(list))
    for (const json& row : results.at(list))
      if (row.at("suite") == suite) rows.push_back(row);
  return rows;
}

std::string table_text(const Suite& suite, const json& rows, const report::Paint& paint) {
  std::vector<report::Column> columns;
  for (const ShownColumn& column : suite.columns)
    columns.push_back(
        {column.title, is_number(rows, column.key) ? report::Align::right : report::Align::left});
  report::TextTable table(std::move(columns));
  for (const json& row : rows) {
    std::vector<std::string> cells;
    for (const ShownColumn& column : suite.columns) cells.push_back(cell(row, column.key));
    table.add(std::move(cells));
  }
  return table.text(paint, "  ");
}

std::string fit_text(const json& fit) {
  const std::string precision = fit.at("precision").get<std::string>();
  std::string text = "  " + fit.at("scene").get<std::string>() + ", " + fit.at("engine").get<std::string>() +
                     (precision.empty() ? "" : " " + precision) + ", " + fit.at("over").get<std::string>() +
                     ": ";
  return text + "time ~ N^" + report::brief(fit.at("exponent").get<double>()) +
         " (95 %: " + report::brief(fit.at("exponent_low").get<double>()) + " … " +
         report::brief(fit.at("exponent_high").get<double>()) + ")\n";
}

std::string ratio_text(const json& ratio) {
  return "  " + ratio.at("what").get<std::string>() + ": " + report::brief(ratio.at("median").get<double>()) +
         " (" + report::brief(ratio.at("min").get<double>()) + " … " +
         report::brief(ratio.at("max").get<double>()) + ")\n";
}

std::string skin_text(const json& best) {
  return "  best skin of " + best.at("who").get<std::string>() + ": " +
         report::brief(best.at("skin").get<double>()) + " diameters\n";
}

std::string order_text(const json& order) {
  return "  order " + report::two_decimals(order.at("order").get<double>()) + ": " +
         order.at("scene").get<std::string>() + ", " + order.at("engine").get<std::string>() + " " +
         order.at("precision").get<std::string>() + ", " + order.at("integrator").get<std::string>() + "\n";
}

std::string known_text(const json& known) {
  return "  " + known.at("engine").get<std::string>() +
         (known.at("reproduced").get<bool>() ? " reproduces" : " DOES NOT reproduce") +
         " the errors that it is known to make; the largest deviation is " +
         report::brief(100.0 * known.at("largest_deviation").get<double>()) + " %\n";
}

std::string time_to_error_text(const json& time) {
  const std::string who = time.at("who").get<std::string>() + ", " + time.at("integrator").get<std::string>();
  const std::string what =
      "  to an error of " + report::brief(time.at("error").get<double>()) + " in the pair gas, " + who + ": ";
  if (time.at("wall_s").is_null()) return what + "not reached\n";
  return what + report::duration(time.at("wall_s").get<double>()) + ", " +
         report::brief(time.at("steps_per_contact").get<double>()) + " steps a contact\n";
}

std::string failure_text(const json& row) {
  std::string text = "  " + row.at("scene").get<std::string>() + ", " + row.at("engine").get<std::string>() +
                     " " + row.at("precision").get<std::string>() + ", " +
                     row.at("integrator").get<std::string>();
  if (row.contains("steps_per_contact")) text += ", " + cell(row, "steps_per_contact") + " steps a contact";
  return text + ": " + row.at("status").get<std::string>() + "\n";
}

std::string with_what(const json& decade) {
  std::string engine = decade.at("engine").get<std::string>();
  if (engine == "opencl") engine += " " + decade.at("precision").get<std::string>();
  return engine + ", " + decade.at("integrator").get<std::string>() + ", " +
         cell(decade, "steps_per_contact");
}

/// A row a scene and decade, with the cheapest way of ours and of each peer.
std::string decades_text(const json& decades, const report::Paint& paint) {
  std::map<std::pair<std::string, int>, std::map<std::string, const json*>> rows;
  for (const json& decade : decades)
    rows[{decade.at("scene").get<std::string>(), -decade.at("decade").get<int>()}]
        [decade.at("side").get<std::string>()] = &decade;
  report::TextTable table({{"scene", report::Align::left},
                           {"error", report::Align::right},
                           {"ours", report::Align::right},
                           {"with, steps a contact", report::Align::left},
                           {"LAMMPS", report::Align::right},
                           {"LIGGGHTS", report::Align::right}});
  for (const auto& [key, sides] : rows) {
    const auto time = [&](const char* side) {
      return sides.contains(side) ? report::duration(sides.at(side)->at("wall_s").get<double>())
                                  : std::string();
    };
    table.add({key.first, report::brief(std::pow(10.0, -key.second)), time("ours"),
               sides.contains("ours") ? with_what(*sides.at("ours")) : "", time("lammps"), time("liggghts")});
  }
  return rows.empty() ? "" : "  What each decade of accuracy costs\n" + table.text(paint, "  ");
}

std::string share_text(const json& safe) {
  return "  " + safe.at("integrator").get<std::string>() + ", " + safe.at("scene").get<std::string>() +
         ", restitution " + safe.at("restitution").get<std::string>() + ": stable to " +
         report::brief(safe.at("share").get<double>()) + " of a contact, run permits " +
         report::brief(safe.at("permitted_share").get<double>()) + "\n";
}

std::string agreement_text(const json& one) {
  return "  predicted and measured at most " + report::brief(one.at("worst").get<double>()) + " apart, bar " +
         report::brief(one.at("bar").get<double>()) + ": " + std::to_string(one.at("points").get<int>()) +
         " limits, " + std::to_string(one.at("beyond").get<int>()) +
         " beyond; permitted above the limit: " + std::to_string(one.at("permitted_above").get<int>()) + "\n";
}

std::string per_cent(const json& row, const char* key) {
  return report::brief(100.0 * row.at(key).get<double>()) + " %";
}

std::string cost_text(const json& cost) {
  const std::string what = "  " + cost.at("cost").get<std::string>() + ", " +
                           cost.at("scene").get<std::string>() + ", " + cost.at("engine").get<std::string>() +
                           " " + cost.at("precision").get<std::string>() + ": ";
  if (!cost.contains("bound")) return what + "two pairs at least make a bound\n";
  return what + per_cent(cost, "mean") + ", at most " + per_cent(cost, "bound") + " (95 %, " +
         std::to_string(cost.at("pairs").get<int>()) + " pairs), bar " + per_cent(cost, "bar") + ": " +
         cost.at("verdict").get<std::string>() + "; of processor time " + per_cent(cost, "cpu_mean") +
         ", at most " + per_cent(cost, "cpu_bound") + "\n";
}

std::string worst_text(const json& one) {
  return "  " + one.at("scene").get<std::string>() + ", friction " + one.at("friction").get<std::string>() +
         ", " + one.at("engine").get<std::string>() + " " + one.at("precision").get<std::string>() + ": " +
         one.at("what").get<std::string>() + " at most " + report::brief(one.at("worst").get<double>()) +
         " from the predicted one, " + std::to_string(one.at("points").get<int>()) + " cases\n";
}

}  // namespace

std::string suite_text(const Suite& suite, const json& results, const report::Paint& paint) {
  std::ostringstream text;
  text << paint.bold(suite.name) << ": " << suite.what << "\n"
       << table_text(suite, rows_of_suite(results, "results", suite.name), paint);
  for (const json& fit : rows_of_suite(results, "fits", suite.name))
    if (fit.contains("exponent")) text << fit_text(fit);
  for (const json& ratio : rows_of_suite(results, "ratios", suite.name)) text << ratio_text(ratio);
  for (const json& best : rows_of_suite(results, "best_skins", suite.name)) text << skin_text(best);
  for (const json& order : rows_of_suite(results, "orders", suite.name)) text << order_text(order);
  for (const json& known : rows_of_suite(results, "known_errors", suite.name)) text << known_text(known);
  for (const json& time : rows_of_suite(results, "times_to_error", suite.name))
    text << time_to_error_text(time);
  text << decades_text(rows_of_suite(results, "decades", suite.name), paint);
  for (const json& safe : rows_of_suite(results, "safe_shares", suite.name)) text << share_text(safe);
  for (const json& one : rows_of_suite(results, "agreement", suite.name)) text << agreement_text(one);
  for (const json& one : rows_of_suite(results, "worst", suite.name)) text << worst_text(one);
  for (const json& cost : rows_of_suite(results, "costs", suite.name)) text << cost_text(cost);
  const json failed = rows_of_suite(results, "failed", suite.name);
  if (!failed.empty()) text << "  Not measured, with the reason\n";
  for (const json& row : failed) text << failure_text(row);
  return text.str();
}

}  // namespace grainproof::app
