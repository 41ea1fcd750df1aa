// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/hertz_passage.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

namespace grainproof::analytic {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr double half_pi = boost::math::constants::half_pi<double>();

/// ∫ (sin φ)^(−1/5) e^(rate φ/5) dφ from 0 to root⁵. With φ = s⁵ the integrand is smooth.
double elapsed(double rate, double root) {
  return boost::math::quadrature::gauss<double, 30>::integrate(
      [rate](double s) {
        const double angle = std::pow(s, 5);
        const double flatness = angle > 0.0 ? std::sin(angle) / angle : 1.0;
        return 5.0 * s * s * s * std::pow(flatness, -0.2) * std::exp(0.2 * rate * angle);
      },
      0.0, root);
}

}  // namespace

HertzPassage::HertzPassage(const HertzPair& pair, double speed)
    : pair_(pair),
      speed_(speed),
      under_damping_(std::sqrt((1.0 - pair.damping_ratio) * (1.0 + pair.damping_ratio))),
      decay_(pair.damping_ratio / under_damping_),
      frequency_(under_damping_ * std::sqrt(1.25 * pair.force_constant() / pair.mass)) {
  const double middle = std::pow(half_pi, 0.2);
  in_ = time_in(middle);
  duration_ = in_ + time_out(middle);
}

/// From the onset to the angle root⁵.
double HertzPassage::time_in(double root) const {
  return std::pow(1.25 * speed_ / frequency_, -0.2) / frequency_ * elapsed(decay_, root);
}

/// From the angle π − root⁵ to the end.
double HertzPassage::time_out(double root) const {
  return std::pow(1.25 * speed_ / frequency_, -0.2) / frequency_ * std::exp(0.2 * decay_ * pi) *
         elapsed(-decay_, root);
}

/// `from_end` is π − `angle`, given as well so that neither end loses digits.
Motion HertzPassage::gap_at(double angle, double from_end) const {
  const double left = std::exp(-decay_ * angle), sine = std::sin(std::min(angle, from_end));
  const double q = 1.25 * speed_ / frequency_ * left * sine;
  return {-std::pow(q, 0.8), -speed_ * left * (std::cos(angle) - decay_ * sine)};
}

double HertzPassage::root_of(double time, double (HertzPassage::*time_to)(double) const) const {
  if (time <= 0.0) return 0.0;
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      [&](double root) { return (this->*time_to)(root)-time; }, 0.0, std::pow(half_pi, 0.2) * (1.0 + 1e-12),
      boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

Motion HertzPassage::gap(double time) const {
  if (time >= duration_) return {exit_speed() * (time - duration_), exit_speed()};
  if (time <= in_) {
    const double angle = std::pow(root_of(time, &HertzPassage::time_in), 5);
    return gap_at(angle, pi - angle);
  }
  const double from_end = std::pow(root_of(duration_ - time, &HertzPassage::time_out), 5);
  return gap_at(pi - from_end, from_end);
}

double HertzPassage::force_zero() const {
  // q'' = 0, at the angle π − 2 arctan(decay).
  const double from_end = 2.0 * std::atan(decay_);
  if (from_end <= half_pi) return duration_ - time_out(std::pow(from_end, 0.2));
  return time_in(std::pow(pi - from_end, 0.2));
}

double HertzPassage::peak_overlap() const {
  // The velocity is zero where tan ωθ = 1/decay.
  const double angle = std::atan2(1.0, decay_);
  return -gap_at(angle, pi - angle).position;
}

double HertzPassage::exit_speed() const {
  return speed_ * std::exp(-decay_ * pi);
}

double HertzPassage::largest_force() const {
  return pair_.force_constant() * std::pow(peak_overlap(), 1.5);
}

}  // namespace grainproof::analytic
