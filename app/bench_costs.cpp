// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_costs.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "app/bench_suites.hpp"

namespace grainproof::app {
namespace {

constexpr double confidence = 0.95;

/// The same scene and cost without it; what mixed is held against computes in single.
bool is_without(const Sample& one, const Sample& with) {
  const bool same_precision = with.key("cost") == "mixed" || one.key("precision") == with.key("precision");
  return one.key("with") == "no" && one.key("cost") == with.key("cost") &&
         one.key("scene") == with.key("scene") && one.key("engine") == with.key("engine") && same_precision;
}

nlohmann::json row_of(const std::vector<Sample>& samples, const Sample& with, const Sample& without) {
  nlohmann::json row;
  for (const auto& [name, value] : with.keys)
    if (name != "with") row[name] = value;
  const auto wall = ratios(samples, with.subject(), without.subject(), "step_s");
  const auto found = cost_bound(wall);
  row["pairs"] = wall.size();
  row["bar"] = with.value("bar");
  if (const double bytes = with.value("bytes_per_particle"); bytes > 0.0) row["bytes_per_particle"] = bytes;
  if (const double bytes = without.value("bytes_per_particle"); bytes > 0.0)
    row["bytes_per_particle_without"] = bytes;
  if (!found) return row;
  row["mean"] = found->mean;
  row["bound"] = found->bound;
  row["verdict"] = found->bound <= with.value("bar") ? "yes" : "no";
  const auto cpu = cost_bound(ratios(samples, with.subject(), without.subject(), "cpu_step_s"));
  row["cpu_mean"] = cpu->mean;
  row["cpu_bound"] = cpu->bound;
  return row;
}

}  // namespace

std::optional<CostBound> cost_bound(std::span<const double> ratios) {
  const auto count = static_cast<double>(ratios.size());
  if (ratios.size() < 2) return std::nullopt;
  double mean = 0.0, squares = 0.0;
  for (const double ratio : ratios) mean += std::log(ratio) / count;
  for (const double ratio : ratios) squares += std::pow(std::log(ratio) - mean, 2);
  const boost::math::students_t distribution(count - 1.0);
  const double spread = std::sqrt(squares / (count - 1.0) / count);
  return CostBound{std::expm1(mean),
                   std::expm1(mean + boost::math::quantile(distribution, confidence) * spread)};
}

void measure_costs(BenchSession& session) {
  const std::int64_t size = session.quick() ? 10000 : 100000;
  const auto& here = session.engines();
  const bool single = session.options().engines.empty() && std::ranges::count(here, "opencl:single") > 0;
  const std::vector<std::string> engines = single ? std::vector<std::string>{"opencl:single"} : here;
  conclude_costs(session, session.run({.suite = "costs",
                                       .what = "each on and off, in turns",
                                       .engines = engines,
                                       .particles = within_limits(session, {size}),
                                       .rounds = session.quick() ? 6 : 30,
                                       .seconds = session.quick() ? 0.05 : 0.1}));
}

void conclude_costs(BenchSession& session, const std::vector<Sample>& samples) {
  const std::vector<Sample> all = subjects(samples);
  for (const Sample& with : all) {
    if (with.key("with") != "yes" || !with.error.empty()) continue;
    const auto without = std::ranges::find_if(all, [&](const Sample& one) { return is_without(one, with); });
    if (without != all.end()) session.extra["costs"].push_back(row_of(samples, with, *without));
  }
}

}  // namespace grainproof::app
