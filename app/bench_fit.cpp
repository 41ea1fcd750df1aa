// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_fit.hpp"

#include <Eigen/Dense>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

namespace grainproof::app {
namespace {

constexpr std::size_t fewest_points = 4;

struct Linear {
  double intercept, factor, sum_of_squares;
};

/// The best intercept and factor for one exponent: linear least squares of 1 = (a + b N^p)/t.
Linear linear_fit(std::span<const Timed> points, double exponent, bool with_intercept) {
  const auto rows = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd matrix(rows, with_intercept ? 2 : 1);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Timed& point = points[static_cast<std::size_t>(i)];
    matrix(i, 0) = std::pow(point.particles, exponent) / point.seconds;
    if (with_intercept) matrix(i, 1) = 1.0 / point.seconds;
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows);
  const Eigen::VectorXd found = matrix.colPivHouseholderQr().solve(ones);
  const double squares = (matrix * found - ones).squaredNorm();
  if (with_intercept && found[1] < 0.0) return linear_fit(points, exponent, false);
  return {with_intercept ? found[1] : 0.0, found[0], squares};
}

/// Golden section: the sum of squares has one minimum over the exponents that are thinkable.
double best_exponent(std::span<const Timed> points, bool with_intercept) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.2, high = 3.0;
  while (high - low > 1e-7) {
    const double one = high - golden * (high - low), two = low + golden * (high - low);
    if (linear_fit(points, one, with_intercept).sum_of_squares <
        linear_fit(points, two, with_intercept).sum_of_squares)
      high = two;
    else
      low = one;
  }
  return 0.5 * (low + high);
}

/// Half the width of the exponent's confidence interval, from the curvature at the minimum.
double half_width(std::span<const Timed> points, const PowerLaw& law) {
  const bool with_intercept = law.intercept > 0.0;
  const int unknowns = with_intercept ? 3 : 2;
  const int freedom = static_cast<int>(points.size()) - unknowns;
  Eigen::MatrixXd jacobian(points.size(), unknowns);
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double power = std::pow(points[i].particles, law.exponent);
    jacobian(row, 0) = law.factor * power * std::log(points[i].particles) / points[i].seconds;
    jacobian(row, 1) = power / points[i].seconds * law.factor;
    if (with_intercept) jacobian(row, 2) = law.intercept / points[i].seconds;
    squares += std::pow((law.intercept + law.factor * power) / points[i].seconds - 1.0, 2);
  }
  const Eigen::MatrixXd inverse = (jacobian.transpose() * jacobian).inverse();
  const boost::math::students_t distribution(freedom);
  return boost::math::quantile(distribution, 0.975) * std::sqrt(squares / freedom * inverse(0, 0));
}

PowerLaw fitted(std::span<const Timed> points, bool with_intercept) {
  PowerLaw law{};
  law.exponent = best_exponent(points, with_intercept);
  const Linear linear = linear_fit(points, law.exponent, with_intercept);
  law.intercept = linear.intercept;
  law.factor = linear.factor;
  const double half = half_width(points, law);
  law.exponent_low = law.exponent - half;
  law.exponent_high = law.exponent + half;
  return law;
}

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const Timed> points, std::optional<double> known_intercept) {
  if (points.size() < fewest_points) return std::nullopt;
  if (!known_intercept) return fitted(points, true);
  std::vector<Timed> beyond(points.begin(), points.end());
  for (Timed& point : beyond) point.seconds -= *known_intercept;
  PowerLaw law = fitted(beyond, false);
  law.intercept = *known_intercept;
  return law;
}

}  // namespace grainproof::app
