// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/statistic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace grainproof {
namespace {

double largest(std::span<const double> errors) {
  double size = 0.0;
  for (const double error : errors) size = std::max(size, std::abs(error));
  return size;
}

double root_mean_square(std::span<const double> errors) {
  const double squares = std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0);
  return std::sqrt(squares / static_cast<double>(errors.size()));
}

}  // namespace

double mean_of(std::span<const double> errors) {
  return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

double statistic_of(Statistic statistic, std::span<const double> errors) {
  const bool all_numbers =
      std::none_of(errors.begin(), errors.end(), [](double error) { return std::isnan(error); });
  if (errors.empty() || !all_numbers) return std::numeric_limits<double>::quiet_NaN();
  switch (statistic) {
    case Statistic::maximum:
      return largest(errors);
    case Statistic::rms:
      return root_mean_square(errors);
    case Statistic::mean:
      return mean_of(errors);
    case Statistic::band:  // of two samples, not of errors
      break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double order_of_convergence(std::span<const std::pair<double, double>> points) {
  const auto count = static_cast<double>(points.size());
  double x = 0.0;
  double y = 0.0;
  for (const auto& [step, error] : points) {
    x += std::log(step) / count;
    y += std::log(std::abs(error)) / count;
  }
  double covariance = 0.0;
  double variance = 0.0;
  for (const auto& [step, error] : points) {
    covariance += (std::log(step) - x) * (std::log(std::abs(error)) - y);
    variance += (std::log(step) - x) * (std::log(step) - x);
  }
  return covariance / variance;
}

}  // namespace grainproof
