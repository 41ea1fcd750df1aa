// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/judging/claims.hpp"

#include <algorithm>

namespace grainproof {
namespace {

bool starts_with(const std::string& text, const char* beginning) {
  return text.rfind(beginning, 0) == 0;
}

/// Finds the quantity and the oracle; a claim that names what does not exist fails by itself.
Claim resolved(const Expectation& expectation, const Oracles& oracles) {
  Claim claim{&expectation, quantity_named(expectation.quantity), nullptr, {}, {}, {}};
  const std::string& against = expectation.against;
  if (!claim.quantity) {
    claim.impossible = "there is no quantity \"" + expectation.quantity + "\"";
  } else if (expectation.statistic == Statistic::band && !claim.quantity->value) {
    claim.impossible = "\"" + expectation.quantity + "\" is no single number, so it has no band";
  } else if (starts_with(against, "closed_form:") || starts_with(against, "engine:")) {
    claim.oracle = oracles ? oracles(against) : nullptr;
    if (!claim.oracle && starts_with(against, "closed_form:")) claim.impossible = "there is no " + against;
  } else if (!starts_with(against, "value:") && !starts_with(against, "invariant:")) {
    claim.impossible = "\"" + against + "\" is no closed_form:, engine:, invariant: or value:";
  }
  return claim;
}

Support oracle_support(const Claim& claim, const Scene& scene) {
  if (!starts_with(claim.says->against, "engine:")) return {};
  if (!claim.oracle) return Support::no(claim.says->against + " is not here");
  const Support support = claim.oracle->supports(scene, claim.quantity->request());
  return support ? support : Support::no(claim.says->against + ": " + support.because);
}

void note(std::vector<Refusal>& refusals, Refusal refusal) {
  if (std::find(refusals.begin(), refusals.end(), refusal) == refusals.end())
    refusals.push_back(std::move(refusal));
}

/// Keeps the scenes that the engine and the oracle can do.
void take_supported(Claim& claim, const Case& subject, Engine& engine, std::vector<Refusal>& refusals) {
  for (std::size_t i = 0; i < subject.scenes.size(); ++i) {
    const Scene& scene = subject.scenes[i].scene;
    if (!matches(*claim.says, subject.scenes[i])) continue;
    const std::string integrator(name_of(scene.run.integrator));
    const Support plain = engine.supports(scene, {});
    const Support asked = plain ? engine.supports(scene, claim.quantity->request()) : plain;
    const Support oracle = asked ? oracle_support(claim, scene) : asked;
    if (oracle)
      claim.scenes.push_back(i);
    else
      note(refusals, {oracle.because, integrator, plain ? claim.says->quantity : ""});
  }
}

}  // namespace

bool matches(const Expectation& expectation, const ResolvedScene& resolved) {
  return std::all_of(expectation.where.begin(), expectation.where.end(), [&](const auto& wanted) {
    const auto& [key, value] = wanted;
    if (key == "step") return resolved.point.step == value;
    if (key == "integrator") return name_of(resolved.scene.run.integrator) == value;
    const auto found = resolved.point.values.find(key);
    return found != resolved.point.values.end() && found->second == value;
  });
}

bool is_meant(const Expectation& expectation, const std::string& engine) {
  const auto names = [&](const std::string& wanted) {
    return engine == wanted || engine.rfind(wanted + ":", 0) == 0;
  };
  return expectation.engines.empty() ||
         std::any_of(expectation.engines.begin(), expectation.engines.end(), names);
}

std::vector<Claim> claims_for(const Case& subject, Engine& engine, const Oracles& oracles,
                              std::vector<Refusal>& refusals) {
  std::vector<Claim> claims;
  for (const Expectation& expectation : subject.expectations) {
    const bool about_itself = expectation.against == "engine:" + engine.name();
    if (!expectation.outcome.empty() || about_itself || !is_meant(expectation, engine.name())) continue;
    Claim claim = resolved(expectation, oracles);
    const bool any = std::any_of(subject.scenes.begin(), subject.scenes.end(),
                                 [&](const ResolvedScene& scene) { return matches(expectation, scene); });
    if (claim.impossible.empty() && !any) claim.impossible = "no point of the sweep matches `for`";
    if (claim.impossible.empty()) take_supported(claim, subject, engine, refusals);
    claims.push_back(std::move(claim));
  }
  return claims;
}

}  // namespace grainproof
