// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/flow_terms.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

/// As many as the kernel has reciprocals for: enough up to the limit of stability.
constexpr int most_terms = 24;

int terms_of(double p, double q, double last_digit) {
  double before = 1.0, now = 1.0;
  int terms = 4;
  for (int n = 2; n < most_terms && now + before > last_digit * (p + q); ++n) {
    const double next = ((n - 1) * p * now + q * before) / (n * (n - 1));
    before = std::exchange(now, next);
    terms = std::max(terms, n + 1);
  }
  return terms;
}

}  // namespace

int flow_terms(const Scene& scene, double last_digit) {
  double lightest = std::numeric_limits<double>::max();
  for (const Particle& p : scene.particles) lightest = std::min(lightest, mass_of(p, scene) / 2);
  const auto material = static_cast<std::size_t>(scene.particles.front().material);
  int most = 0;
  for (std::size_t other = 0; other < scene.materials.size(); ++other) {
    if (!scene.contacts.has(material, other)) continue;
    const PairCoefficients c = coefficients_of(scene, material, other);
    const double h = scene.run.step, damping = c.damping.at(lightest);
    most = std::max(most, terms_of(h * damping / lightest, h * h * c.stiffness / lightest, last_digit));
  }
  return most;
}

}  // namespace grainproof::opencl
