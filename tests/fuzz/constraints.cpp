// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/constraints.hpp"

#include <algorithm>
#include <cmath>

namespace grainproof::fuzz {
namespace {

bool positive(double x) {
  return std::isfinite(x) && x > 0.0;
}

std::string broken_record(const RunSettings& run) {
  const std::vector<double>& times = run.sample_times;
  if (times.size() < 2 || times.front() != 0.0 || times.back() != run.end) return "samples from 0 to the end";
  if (times.size() > 1'000'002) return "up to 1e6 frames";
  if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end())
    return "samples in order";
  return "";
}

std::string broken_run(const RunSettings& run) {
  if (!positive(run.end)) return "run.end above 0";
  if (!positive(run.step)) return "run.step above 0";
  if (!(run.end / run.step <= 1e15)) return "up to 1e15 steps";
  if (!(run.overlap_limit > 0.0 && run.overlap_limit < 2.0)) return "overlap_limit above 0 and below 2";
  if (!(run.skin == -1.0 || run.skin == RunSettings::searched_skin ||
        (std::isfinite(run.skin) && run.skin >= 0.0)))
    return "skin not negative";
  return broken_record(run);
}

std::string broken_domain(const Scene& scene) {
  const Domain& domain = scene.domain;
  if (!domain.lower.allFinite() || !domain.upper.allFinite() || !domain.extent().allFinite())
    return "a finite domain";
  if (!(domain.lower.array() < domain.upper.array()).all()) return "domain.upper above lower";
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.effect_diameter);
  for (int axis = 0; axis < 3; ++axis)
    if (domain.periodic(axis) && !(domain.extent()[axis] > 2.0 * largest))
      return "a period above two diameters";
  return "";
}

std::string broken_field(const Scene& scene) {
  return std::visit(
             Overloaded{[](const ConstantGravity& g) { return g.acceleration.allFinite(); },
                        [](const RotatingGravity& g) {
                          return std::isfinite(g.magnitude) && g.magnitude >= 0.0 && positive(g.time_scale);
                        },
                        [](const CentralGravity& g) {
                          return std::isfinite(g.magnitude) && g.magnitude >= 0.0 && g.centre.allFinite();
                        }},
             scene.gravity) &&
                 std::visit(Overloaded{[](const NoFlow&) { return true; },
                                       [](const UniformFlow& flow) {
                                         return positive(flow.viscosity) && flow.velocity.allFinite();
                                       },
                                       [](const TaylorGreenFlow& flow) {
                                         return positive(flow.viscosity) && std::isfinite(flow.amplitude) &&
                                                positive(flow.wave_number);
                                       }},
                            scene.flow)
             ? ""
             : "finite fields";
}

std::string broken_scene(const Scene& scene) {
  for (const auto& check : {broken_domain, broken_law, broken_body, broken_wall, broken_field})
    if (std::string broken = check(scene); !broken.empty()) return broken;
  if (scene.orientation != OrientationUpdate::none && !scene.rotation)
    return "orientation with rotation only";
  return broken_run(scene.run);
}

bool met(const Expectation& says, const ResolvedScene& scene) {
  return std::all_of(says.where.begin(), says.where.end(), [&](const auto& wanted) {
    const auto& [key, label] = wanted;
    if (key == "step") return scene.point.step == label;
    if (key == "integrator") return name_of(scene.scene.run.integrator) == label;
    return scene.point.values.contains(key) && scene.point.values.at(key) == label;
  });
}

std::string broken_claim(const Expectation& says, const Case& read) {
  if (!says.outcome.empty())
    return says.outcome == "refused" || says.outcome == "went_wrong" ? "" : "outcome";
  if (says.quantity.empty() && says.against.empty()) return "an expectation of something";
  if (says.below.empty() && !says.order && !says.sign) return "below, order or sign";
  for (const auto& [step, bound] : says.below)
    if (!(bound >= 0.0 && std::isfinite(bound))) return "a bound not negative";
  if (!(says.ulps >= 0.0)) return "ulps not negative";
  if (says.sign && *says.sign != 1 && *says.sign != -1) return "a sign of 1 or -1";
  if (says.statistic == Statistic::band && !says.against.starts_with("engine:"))
    return "a band of two engines";
  const auto one = [&](const ResolvedScene& scene) { return met(says, scene); };
  return std::any_of(read.scenes.begin(), read.scenes.end(), one) ? "" : "a point for every expectation";
}

}  // namespace

std::string broken_constraint(const Case& read, const ReadOptions& options) {
  if (!read.refused.empty()) return read.scenes.empty() ? "" : "no scenes where the input is refused";
  if (read.scenes.empty()) return "at least one scene";
  if (read.scenes.size() > options.most_scenes) return "no more scenes than admitted";
  std::size_t particles = 0;
  for (const ResolvedScene& resolved : read.scenes) {
    particles += resolved.scene.particles.size();
    if (std::string broken = broken_scene(resolved.scene); !broken.empty()) return broken;
  }
  if (particles > options.most_particles) return "no more particles than admitted";
  for (const Expectation& says : read.expectations)
    if (std::string broken = broken_claim(says, read); !broken.empty()) return broken;
  return "";
}

}  // namespace grainproof::fuzz
