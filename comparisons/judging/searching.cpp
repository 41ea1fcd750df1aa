// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/judging/searching.hpp"

#include <exception>
#include <limits>
#include <map>
#include <utility>

namespace grainproof {
namespace {

/// By quantity and scene.
using FoundBefore = std::map<std::pair<std::string, std::size_t>, Found>;

/// What the claim's closed form or number says; an engine is searched itself.
std::vector<Found> exact_values(const Claim& claim, std::span<const Scene> scenes) {
  const std::string& against = claim.says->against;
  const std::vector<double> no_hints(scenes.size(), std::numeric_limits<double>::quiet_NaN());
  if (against.rfind("engine:", 0) == 0) return claim.quantity->search(scenes, *claim.oracle, no_hints);
  std::vector<Found> exact;
  for (const Scene& scene : scenes) {
    if (!claim.oracle) {
      exact.push_back({Measured::of(std::stod(against.substr(against.find(':') + 1))), {}, 0.0});
      continue;
    }
    const Observations seen = claim.oracle->observe(scene, {});
    const auto told = seen.scalars.find(claim.says->quantity);
    exact.push_back({told == seen.scalars.end() ? Measured::none(against + " does not say it")
                                                : Measured::of(told->second),
                     {},
                     0.0});
  }
  return exact;
}

void search_claim(const Case& subject, Engine& engine, Claim& claim, FoundBefore& before) {
  std::vector<Scene> scenes;
  for (const std::size_t i : claim.scenes) scenes.push_back(subject.scenes[i].scene);
  const std::vector<Found> exact = exact_values(claim, scenes);
  std::vector<Scene> fresh;
  std::vector<double> hints;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    if (before.contains({claim.says->quantity, claim.scenes[k]})) continue;
    fresh.push_back(scenes[k]);
    hints.push_back(exact[k].value.value);
  }
  const std::vector<Found> found = claim.quantity->search(fresh, engine, hints);
  std::size_t next = 0;
  for (const std::size_t i : claim.scenes)
    if (!before.contains({claim.says->quantity, i})) before[{claim.says->quantity, i}] = found[next++];
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const Found& own = before.at({claim.says->quantity, claim.scenes[k]});
    claim.findings.push_back({claim.scenes[k], relative_error(own.value, exact[k].value),
                              own.provenance.unit_roundoff + exact[k].provenance.unit_roundoff, own.wall_s});
  }
}

}  // namespace

std::string search_claims(const Case& subject, Engine& engine, std::vector<Claim>& claims) {
  FoundBefore before;
  for (Claim& claim : claims) {
    if (!claim.quantity || !claim.quantity->search || claim.scenes.empty()) continue;
    try {
      search_claim(subject, engine, claim, before);
    } catch (const std::exception& failure) {
      claim.findings.clear();
      for (const std::size_t i : claim.scenes)
        claim.findings.push_back({i, Measured::none(failure.what()), 0.0, 0.0});
    }
  }
  return before.empty() ? "" : before.begin()->second.provenance.precision;
}

}  // namespace grainproof
