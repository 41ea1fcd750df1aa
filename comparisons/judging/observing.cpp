// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/judging/observing.hpp"

#include <algorithm>
#include <optional>

namespace grainproof {
namespace {

constexpr std::size_t chunk_bytes = std::size_t{64} << 20;  // frames held at a time
constexpr std::size_t chunk_scenes = 512;

/// What all claims together need of each scene; empty where none needs it.
std::vector<std::optional<Request>> requests(const Case& subject, const std::vector<Claim>& claims) {
  std::vector<std::optional<Request>> needed(subject.scenes.size());
  for (const Claim& claim : claims) {
    if (!claim.quantity || claim.quantity->search) continue;
    for (const std::size_t scene : claim.scenes) {
      if (!needed[scene]) needed[scene].emplace();
      needed[scene]->every_step |= claim.quantity->every_step;
      needed[scene]->ledger |= claim.quantity->ledger;
    }
  }
  return needed;
}

bool alike(const Request& a, const Request& b) {
  return a.every_step == b.every_step && a.ledger == b.ledger;
}

std::vector<Chunk> chunks(const Case& subject, const std::vector<Claim>& claims) {
  const auto needed = requests(subject, claims);
  std::vector<Chunk> all;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (!needed[i]) continue;
    const std::size_t own = frame_bytes(subject.scenes[i].scene, *needed[i]);
    const bool fits = !all.empty() && alike(all.back().request, *needed[i]) && bytes + own <= chunk_bytes &&
                      all.back().scenes.size() < chunk_scenes;
    if (!fits) {
      all.push_back({*needed[i], {}});
      bytes = 0;
    }
    all.back().scenes.push_back(i);
    bytes += own;
  }
  return all;
}

Measured error_of(const Claim& claim, const Scene& scene, const Observations& seen,
                  const Observations& exact) {
  if (exact.outcome.status == Outcome::Status::went_wrong)
    return Measured::none(claim.says->against + ": " + exact.outcome.reason);
  return claim.quantity->error(scene, seen, exact);
}

/// A band is taken over the two numbers of each sample, whatever their relative error.
void take_numbers(const Claim& claim, const Scene& scene, const Observations& seen, const Observations& exact,
                  Finding& finding) {
  const Measured own = claim.quantity->value(scene, seen);
  const Measured other = claim.quantity->exact_value(scene, exact);
  finding.seen = own.value;
  finding.exact = other.value;
  finding.error = own.exists() && other.exists() ? Measured::of(own.value - other.value)
                                                 : Measured::none(own.because + other.because);
}

/// Adds the findings that one observation gives to every claim that asks for its scene.
void judge_scene(const Case& subject, const Chunk& chunk, std::size_t at, const Observations& seen,
                 std::vector<Claim>& claims, const ExactSide& exact_side) {
  const std::size_t index = chunk.scenes[at];
  const Scene& scene = subject.scenes[index].scene;
  const std::string fault = fault_of(scene, seen);
  const Observations few = chunk.request.every_step ? thinned(scene, seen) : Observations{};
  for (Claim& claim : claims) {
    if (!std::binary_search(claim.scenes.begin(), claim.scenes.end(), index) || claim.quantity->search)
      continue;
    Finding finding{index, Measured::none(fault), seen.provenance.unit_roundoff, seen.wall_s};
    if (fault.empty()) {
      const Observations& asked = chunk.request.every_step && !claim.quantity->every_step ? few : seen;
      const Observations exact = exact_side.of(claim, at, asked);
      finding.error = error_of(claim, scene, asked, exact);
      if (claim.says->statistic == Statistic::band && exact.outcome.status == Outcome::Status::completed)
        take_numbers(claim, scene, asked, exact, finding);
      finding.unit_roundoff += exact.provenance.unit_roundoff;
    }
    claim.findings.push_back(std::move(finding));
  }
}

bool is_oracle(const Case& subject, const std::string& against) {
  return std::any_of(subject.expectations.begin(), subject.expectations.end(),
                     [&](const Expectation& expectation) { return expectation.against == against; });
}

}  // namespace

std::string observe_claims(const Case& subject, Engine& engine, std::vector<Claim>& claims, Records& records,
                           const Progress& progress) {
  const std::string itself = "engine:" + engine.name();
  const bool keep = is_oracle(subject, itself);
  const std::vector<Chunk> all = chunks(subject, claims);
  std::size_t total = 0;
  for (const Chunk& chunk : all) total += chunk.scenes.size();
  std::size_t done = 0;
  std::string precision;
  for (const Chunk& chunk : all) {
    std::vector<Observations> seen = observe_chunk(subject, chunk, engine);
    const ExactSide exact_side(subject, chunk, claims, records);
    for (std::size_t at = 0; at < seen.size(); ++at) {
      if (!seen[at].provenance.precision.empty()) precision = seen[at].provenance.precision;
      judge_scene(subject, chunk, at, seen[at], claims, exact_side);
      if (keep)
        records[{itself, chunk.scenes[at]}] = thinned(subject.scenes[chunk.scenes[at]].scene, seen[at]);
    }
    done += chunk.scenes.size();
    if (progress) progress(done, total);
  }
  return precision;
}

}  // namespace grainproof
