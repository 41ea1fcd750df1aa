// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>

#include "app/bench_fit.hpp"
#include "app/bench_suites.hpp"
#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

void add_ratio(BenchSession& session, const Sample& of, const std::string& what,
               const std::vector<double>& found) {
  if (found.empty()) return;
  const Spread spread = spread_of(found);
  nlohmann::json row;
  for (const auto& [name, value] : of.keys) row[name] = value;
  row["what"] = what;
  row["rounds"] = found.size();
  row["min"] = spread.least;
  row["median"] = spread.median;
  row["max"] = spread.most;
  session.extra["ratios"].push_back(std::move(row));
}

/// Medians of `value` over the rounds against the size, for each engine and way.
std::map<std::string, std::map<double, double>> curves(const std::vector<Sample>& samples,
                                                       const std::string& what, const std::string& value) {
  std::map<std::string, std::map<double, std::vector<double>>> found;
  for (const Sample& sample : samples)
    if (sample.key("what") == what && sample.error.empty())
      found[engine_of(sample) + ", " + sample.key("way")][sample.value("particles")].push_back(
          sample.value(value));
  std::map<std::string, std::map<double, double>> medians;
  for (const auto& [who, sizes] : found)
    for (const auto& [size, all] : sizes) medians[who][size] = spread_of(all).median;
  return medians;
}

void add_update_fit(BenchSession& session, const std::string& who, const std::map<double, double>& curve) {
  std::vector<Timed> points;
  for (const auto& [particles, seconds] : curve) points.push_back({particles, seconds});
  const auto law = fit_power_law(points);
  if (!law) return;
  session.extra["fits"].push_back({{"suite", "neighbours"},
                                   {"scene", "gas"},
                                   {"engine", who},
                                   {"precision", ""},
                                   {"over", "updates"},
                                   {"points", points.size()},
                                   {"exponent", law->exponent},
                                   {"exponent_low", law->exponent_low},
                                   {"exponent_high", law->exponent_high},
                                   {"intercept_s", law->intercept},
                                   {"factor_s", law->factor}});
}

/// Where an engine's lists can't be made alone: steps that make one less steps that make none.
std::map<std::string, std::map<double, double>> updates_by_difference(const std::vector<Sample>& samples) {
  const auto steps = curves(samples, "step", "step_s");
  std::map<std::string, std::map<double, double>> found;
  for (const auto& [who, with] : steps) {
    const std::size_t comma = who.find(", list every step");
    if (comma == std::string::npos) continue;
    const auto without = steps.find(who.substr(0, comma) + ", no list at all");
    if (without == steps.end()) continue;
    for (const auto& [size, seconds] : with)
      if (without->second.contains(size) && seconds > without->second.at(size))
        found[who.substr(0, comma) + ", list"][size] = seconds - without->second.at(size);
  }
  return found;
}

/// Share of a step that goes into lists: rebuilds a step times the time of one.
void add_update_shares(BenchSession& session, const std::vector<Sample>& samples) {
  const auto updates = curves(samples, "update", "update_s");
  const auto cells = updates.find("reference, chain cells");
  if (cells == updates.end()) return;
  for (const Sample& sample : subjects(samples)) {
    const double size = sample.value("particles");
    if (sample.key("what") != "step" || sample.key("way") != "chain cells and list" ||
        !cells->second.contains(size))
      continue;
    const double share =
        sample.value("rebuilds") / sample.value("steps") * cells->second.at(size) / sample.value("step_s");
    add_ratio(session, sample, "share of updates in a step, reference, " + report::brief(size) + " particles",
              {share});
  }
}

void add_best_skins(BenchSession& session, const std::vector<Sample>& samples) {
  std::map<std::string, std::pair<double, double>> best;  // of scene and engine: seconds, skin
  for (const Sample& sample : samples) {
    if (sample.key("what") != "skin" || !sample.error.empty()) continue;
    const auto [at, first] = best.try_emplace(sample.key("scene") + ", " + engine_of(sample), 1e300, 0.0);
    at->second = std::min(at->second, {sample.value("step_s"), std::stod(sample.key("skin"))});
  }
  for (const auto& [who, found] : best)
    session.extra["best_skins"].push_back(
        {{"suite", "neighbours"}, {"who", who}, {"skin", found.second}, {"step_s", found.first}});
}

}  // namespace

void conclude_neighbours(BenchSession& session, const std::vector<Sample>& samples) {
  for (const auto& [who, curve] : curves(samples, "update", "update_s")) add_update_fit(session, who, curve);
  for (const auto& [who, curve] : updates_by_difference(samples)) add_update_fit(session, who, curve);
  add_update_shares(session, samples);
  add_best_skins(session, samples);
}

void conclude_features(BenchSession& session, const std::vector<Sample>& samples) {
  for (const Sample& with : subjects(samples)) {
    if (with.key("with") != "yes") continue;
    Sample without = with;
    without.keys["with"] = "no";
    add_ratio(session, with, with.key("feature") + ", " + with.key("scene") + ", " + engine_of(with),
              ratios(samples, with.subject(), without.subject(), "step_s"));
  }
}

void conclude_peers(BenchSession& session, const std::vector<Sample>& samples) {
  const std::vector<Sample> all = subjects(samples);
  for (const Sample& ours : all)
    for (const Sample& peer : all) {
      const bool one_of_ours = ours.key("engine") == "reference" || ours.key("engine") == "opencl";
      const bool a_peer = peer.key("engine") == "lammps" || peer.key("engine") == "liggghts";
      if (!one_of_ours || !a_peer) continue;
      add_ratio(session, ours,
                ours.key("scene") + ", " + engine_of(ours) + " over " + peer.key("engine") + ", " +
                    ours.key("processes") + " processes",
                ratios(samples, ours.subject(), peer.subject(), "cundall_number"));
    }
}

}  // namespace grainproof::app
