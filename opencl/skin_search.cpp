// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/skin_search.hpp"

#include <algorithm>
#include <cmath>

namespace grainproof::opencl {
namespace {

/// Measured on the dense path: a list costs 300 … 500 ns a particle, an entry in which nobody touches 1 … 2.
constexpr double list_entries = 300.0;
/// What another skin must save to be worth the change.
constexpr double worthwhile = 0.97;
constexpr double finer = 0.8;
constexpr int candidates = 20;  // down to 0.004 diameters
constexpr std::int64_t first_trial = 256;

/// Of the shell in which partners are listed, over that of a sphere.
double shell(double skin, double diameter) {
  return std::pow(1.0 + skin / diameter, 3) - 1.0;
}

}  // namespace

// Along a line through two lists, or with half of the entries in touch where there was but one.
double SkinSearch::entries_at(double skin) const {
  const double now = shell(skin_, diameter_), wanted = shell(skin, diameter_);
  double slope = 0.5 * entries_ / now;
  if (other_skin_ >= 0.0) {
    const double measured = (entries_ - other_entries_) / (now - shell(other_skin_, diameter_));
    slope = std::clamp(measured, 0.1 * slope, 2.0 * slope);
  }
  return std::max(entries_ + slope * (wanted - now), 0.0);
}

bool SkinSearch::learn(double entries, std::int64_t steps) {
  entries_ = entries;
  ++lists_;
  if ((lists_ & (lists_ - 1)) != 0) return false;
  const double steps_a_metre = static_cast<double>(steps) / skin_;
  const auto work = [&](double skin) { return entries_at(skin) + list_entries / (steps_a_metre * skin); };
  double best = skin_;
  for (int k = 0; k < candidates; ++k) {
    const double skin = std::max(least_, widest * diameter_ * std::pow(finer, k));
    if (work(skin) < work(best)) best = skin;
  }
  if (work(best) > worthwhile * work(skin_)) return false;
  other_skin_ = skin_;
  other_entries_ = entries_;
  skin_ = best;
  return true;
}

std::int64_t SkinSearch::next_trial(std::int64_t age) {
  std::int64_t trial = first_trial;
  while (trial <= age) trial *= 4;
  return trial;
}

double first_skin(const Scene& scene) {
  double fastest = 0.0, sum = 0.0, largest = 0.0;
  for (const Particle& p : scene.particles) {
    fastest = std::max(fastest, p.velocity.norm());
    sum += p.diameter;
    largest = std::max(largest, p.diameter);
  }
  const double mean = scene.particles.empty() ? 0.0 : sum / static_cast<double>(scene.particles.size());
  if (fastest == 0.0) return 0.1 * mean;
  // d W/d s = 0 of W = b s + list_entries · 2 v Δt/s, with some 20 entries a diameter.
  const double entries_a_metre = 20.0 / mean;
  const double best = std::sqrt(list_entries * 2.0 * fastest * scene.run.step / entries_a_metre);
  return std::clamp(best, 0.01 * mean, SkinSearch::widest * largest);
}

}  // namespace grainproof::opencl
