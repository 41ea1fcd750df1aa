// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/band.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace grainproof {
namespace {

constexpr double outside = 0.001;  // probability that chance alone leaves the band

struct Sample {
  double mean;
  double error;    ///< variance of the mean
  double freedom;  ///< degrees of
};

Sample summarised(std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  Sample sample{std::accumulate(values.begin(), values.end(), 0.0) / count, 0.0, count - 1.0};
  for (const double value : values) sample.error += (value - sample.mean) * (value - sample.mean);
  sample.error /= sample.freedom * count;
  return sample;
}

/// Welch and Satterthwaite's degrees of freedom.
double freedom_of(const Sample& a, const Sample& b) {
  const double sum = a.error + b.error;
  return sum * sum / (a.error * a.error / a.freedom + b.error * b.error / b.freedom);
}

}  // namespace

double BandDifference::in_bands() const {
  const double apart = std::abs(seen - exact);
  return apart == 0.0 && band == 0.0 ? 0.0 : apart / band;
}

BandDifference band_difference(std::span<const double> seen, std::span<const double> exact) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (seen.size() < 2 || exact.size() < 2) return {nan, nan, nan};
  const Sample a = summarised(seen);
  const Sample b = summarised(exact);
  BandDifference result{a.mean, b.mean, a.error + b.error};
  if (!(result.band > 0.0)) return result;
  const boost::math::students_t distribution(freedom_of(a, b));
  result.band = std::sqrt(result.band) * quantile(complement(distribution, outside / 2.0));
  return result;
}

}  // namespace grainproof
