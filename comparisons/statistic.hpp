// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "model/case.hpp"

namespace grainproof {

/// Of signed errors: the largest size, the root of the mean square, or the signed mean. NaN if any is.
double statistic_of(Statistic statistic, std::span<const double> errors);

/// Signed mean, whatever the statistic, for the claim about a sign.
double mean_of(std::span<const double> errors);

/// Least-squares slope of log |error| against log step over points (step, error), two or more.
double order_of_convergence(std::span<const std::pair<double, double>> points);

}  // namespace grainproof
