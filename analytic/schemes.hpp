// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <compare>
#include <span>
#include <string_view>

#include "analytic/linear_system.hpp"
#include "model/integrators.hpp"

/// What each integrator makes of a linear system in one step (stability.2).
namespace grainproof::analytic {

/// Where a motion that changes sign every step stops decaying, the bound of every scheme here:
///     stiffness k h² + remembered k_t h² + damping (η + drag m/τ) h < 4 m
/// with these numbers as factors (stability.3).
struct FlipCondition {
  double stiffness, remembered, damping, drag;
};

/// By hand, a row an integrator, also for those that only some engine has.
struct LinearScheme {
  std::string_view name;

  /// The matrix that takes the scheme's own state one step on; what it holds stands in docs/stability.md.
  Eigen::MatrixXd (*step)(const LinearSystem& system, double h);

  FlipCondition flip;
  bool gains = false;  ///< stable below 2 (η + m/τ)/k only, since each step adds energy (integrators.7)
  Weakening weakens = Weakening::none;  ///< dashpots: linearised() knows how
  bool composed = false;  ///< of several evaluations: between stable steps may lie unstable ones
};

/// One contact: effective mass, spring, spring that remembers, dashpot, drag rate.
struct LinearContact {
  double mass, stiffness, remembered, damping, drag_rate;
  auto operator<=>(const LinearContact&) const = default;
};

/// Largest step that keeps the flip condition; infinity without a limit.
double flip_limit(const LinearScheme& scheme, const LinearContact& contact);

/// Largest step of one contact in closed form; 0 where there is none, infinity without a limit.
double pair_limit(const LinearScheme& scheme, const LinearContact& contact);

std::span<const LinearScheme> linear_schemes();

/// Throws InputRefused for an integrator without a row.
const LinearScheme& linear_scheme(std::string_view name);
inline const LinearScheme& linear_scheme(Integrator integrator) {
  return linear_scheme(name_of(integrator));
}

}  // namespace grainproof::analytic
