// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/spectral_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grainproof::analytic {
namespace {

/// Above 1 by less than this is round-off; a growth that matters at the limits looked for is 1e-6 and more.
constexpr double round_off = 1e-9;
constexpr int halvings_to_zero = 7;
constexpr double as_good_as_infinite = 31.0;
/// So that no search steps over the unstable steps that a composed scheme may have before stable ones.
constexpr double composed_stride = 1.2;
constexpr double tolerance = 1e-5;

}  // namespace

double growth_a_step(const LinearScheme& scheme, const std::vector<LinearSystem>& parts, double h) {
  double largest = 0.0;
  for (const LinearSystem& part : parts)
    if (part.size() > 0)
      largest = std::max(largest, scheme.step(part, h).eigenvalues().cwiseAbs().maxCoeff());
  return largest;
}

double undamped_limit(const std::vector<LinearSystem>& parts) {
  double fastest = 0.0;
  for (const LinearSystem& part : parts)
    if (part.size() > 0)
      fastest = std::max(fastest, Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                                      part.stiffness + part.remembered, Eigen::EigenvaluesOnly)
                                      .eigenvalues()
                                      .maxCoeff());
  return 2.0 / std::sqrt(fastest);
}

double spectral_limit(const LinearScheme& scheme, const std::vector<LinearSystem>& parts) {
  const auto constant = [&](double) -> const std::vector<LinearSystem>& { return parts; };
  return spectral_limit(scheme, constant, undamped_limit(parts));
}

namespace {

bool is_positive(const Eigen::MatrixXd& symmetric) {
  return symmetric.llt().info() == Eigen::Success;
}

/// (stability.3) with matrices for numbers, and (stability.12) for the scheme that weakens dashpots by
/// themselves.
bool keeps_flip_condition(const LinearScheme& scheme, const LinearSystem& of, double h) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(of.size(), of.size());
  if (scheme.weakens == Weakening::by_itself)
    return is_positive(4.0 * one - h * h * (of.stiffness + of.remembered)) &&
           is_positive(2.0 * one - h * (of.damping + of.drag));
  const FlipCondition& flip = scheme.flip;
  return is_positive(4.0 * one - h * h * (flip.stiffness * of.stiffness + flip.remembered * of.remembered) -
                     h * flip.damping * (of.damping + flip.drag * of.drag));
}

/// Mostly the limit itself, from Cholesky's decomposition alone, but a guess: motions may give way in another
/// manner before. 0 where there is none.
double flip_guess(const LinearScheme& scheme, const std::function<std::vector<LinearSystem>(double h)>& parts,
                  double scale) {
  const auto kept = [&](double h) {
    const std::vector<LinearSystem> systems = parts(h);
    return std::ranges::all_of(systems, [&](const LinearSystem& part) {
      return part.size() == 0 || keeps_flip_condition(scheme, part, h);
    });
  };
  double low = 0.0, high = 2.0 * scale;
  while (kept(high)) {
    if (high > as_good_as_infinite * scale) return 0.0;
    low = high;
    high *= 2.0;
  }
  while (high - low > 0.1 * tolerance * high) {
    const double middle = 0.5 * (low + high);
    (kept(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double spectral_limit(const LinearScheme& scheme,
                      const std::function<std::vector<LinearSystem>(double h)>& parts, double scale) {
  const auto stable = [&](double h) { return growth_a_step(scheme, parts(h), h) <= 1.0 + round_off; };
  if (const double guess = scheme.composed ? 0.0 : flip_guess(scheme, parts, scale);
      guess > 0.0 && stable((1.0 - 0.5 * tolerance) * guess) && !stable((1.0 + 0.5 * tolerance) * guess))
    return guess;
  double low = 1.01 * scale, high = low;
  for (int n = 0; !stable(low); ++n) {
    if (n == halvings_to_zero) return 0.0;
    high = low;
    low *= 0.5;
  }
  const double stride = scheme.composed ? composed_stride : 2.0,
               farthest = 1.01 * as_good_as_infinite * scale;
  while (low == high || stable(high)) {
    if (high > farthest) return std::numeric_limits<double>::infinity();
    low = high;
    high *= stride;
  }
  while (high - low > tolerance * high) {
    const double middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace grainproof::analytic
