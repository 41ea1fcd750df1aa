// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/linear_motion.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

namespace grainproof::analytic {
namespace {

constexpr double pi = boost::math::constants::pi<double>();

bool opposite(double a, double b) {
  return (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0);
}

}  // namespace

LinearMotion::LinearMotion(const Equation& equation, const Motion& start)
    : equation_(equation),
      start_(start),
      beta_(equation.damping / (2.0 * equation.mass)),
      kappa_(equation.stiffness / equation.mass),
      discriminant_(beta_ * beta_ - kappa_),
      frequency_(std::sqrt(std::abs(discriminant_))),
      start_acceleration_(
          (equation.force - equation.damping * start.velocity - equation.stiffness * start.position) /
          equation.mass) {}

LinearMotion::Basis LinearMotion::basis(double time) const {
  if (discriminant_ < 0.0) {
    const double decay = std::exp(-beta_ * time);
    return {decay * std::cos(frequency_ * time), decay * std::sin(frequency_ * time) / frequency_};
  }
  // The slower exponent without cancellation: β − Ω = κ/(β + Ω).
  const double fast = beta_ + frequency_;
  const double slow = fast > 0.0 ? kappa_ / fast : 0.0;
  const double decay = std::exp(-slow * time);
  const double lost = -std::expm1(-2.0 * frequency_ * time);
  return {decay * (1.0 - 0.5 * lost), frequency_ > 0.0 ? decay * lost / (2.0 * frequency_) : decay * time};
}

Motion LinearMotion::at(double time) const {
  const Basis b = basis(time);
  const double velocity = start_.velocity * b.even + (start_acceleration_ + beta_ * start_.velocity) * b.odd;
  if (kappa_ != 0.0) {
    const double rest = equation_.force / equation_.stiffness;
    const double y = start_.position - rest;
    return {rest + y * b.even + (start_.velocity + beta_ * y) * b.odd, velocity};
  }
  if (beta_ == 0.0)
    return {start_.position + (start_.velocity + 0.5 * start_acceleration_ * time) * time,
            start_.velocity + start_acceleration_ * time};
  const double rate = 2.0 * beta_;
  const double gone = -std::expm1(-rate * time) / rate;
  return {start_.position + start_.velocity * time + start_acceleration_ * (time - gone) / rate,
          start_.velocity + start_acceleration_ * gone};
}

double LinearMotion::acceleration(double time) const {
  const Motion now = at(time);
  return (equation_.force - equation_.damping * now.velocity - equation_.stiffness * now.position) /
         equation_.mass;
}

double LinearMotion::half_period() const {
  return pi / frequency_;
}

std::optional<double> LinearMotion::turning_time() const {
  const double even = start_.velocity;
  const double odd = start_acceleration_ + beta_ * start_.velocity;
  if (even == 0.0 && odd == 0.0) return std::nullopt;
  if (discriminant_ < 0.0) {
    double angle = std::atan2(even * frequency_, -odd);
    while (angle <= 0.0) angle += pi;
    return angle / frequency_;
  }
  const double ratio = -even / odd;
  if (!(ratio > 0.0) || std::isinf(ratio) || ratio * frequency_ >= 1.0) return std::nullopt;
  return frequency_ > 0.0 ? std::atanh(ratio * frequency_) / frequency_ : ratio;
}

std::optional<double> LinearMotion::first_time_at(double level) const {
  if (kappa_ == 0.0 && beta_ == 0.0) return first_on_parabola(level);
  const double at_start = start_.position - level;
  const std::optional<double> turn = turning_time();
  if (!turn) return at_start == 0.0 ? std::nullopt : first_after_last_turn(level, 0.0);
  const double at_turn = at(*turn).position - level;
  if (opposite(at_start, at_turn)) return root_between(level, 0.0, *turn);
  if (discriminant_ >= 0.0) return first_after_last_turn(level, *turn);
  // Later swings lie inside this one, so what it misses is never reached.
  const double next = *turn + half_period();
  if (opposite(at_turn, at(next).position - level)) return root_between(level, *turn, next);
  return std::nullopt;
}

std::optional<double> LinearMotion::first_on_parabola(double level) const {
  const double half = 0.5 * start_acceleration_, v = start_.velocity, c = start_.position - level;
  if (half == 0.0) return c * v < 0.0 ? std::optional(-c / v) : std::nullopt;
  if (c == 0.0) return v * half < 0.0 ? std::optional(-v / half) : std::nullopt;
  const double square = v * v - 4.0 * half * c;
  if (square < 0.0) return std::nullopt;
  const double q = -0.5 * (v + std::copysign(std::sqrt(square), v));
  const double one = q / half, other = c / q;
  const double early = std::min(one, other), late = std::max(one, other);
  if (early > 0.0) return early;
  return late > 0.0 ? std::optional(late) : std::nullopt;
}

/// From here the position runs monotonically to rest or away without bound.
std::optional<double> LinearMotion::first_after_last_turn(double level, double from) const {
  const double at_from = at(from).position - level;
  if (at_from == 0.0) return std::nullopt;
  double span = kappa_ != 0.0 ? 1.0 / std::sqrt(std::abs(kappa_)) : 0.5 / beta_;
  double before = at_from;
  for (int doubling = 0; doubling < 64; ++doubling, span *= 2.0) {
    const double now = at(from + span).position - level;
    if (opposite(at_from, now)) return root_between(level, from, from + span);
    if (!(std::abs(now) < std::abs(before))) return std::nullopt;
    before = now;
  }
  return std::nullopt;
}

LinearMotion LinearMotion::combined(double p, double q) const {
  return {{equation_.mass, equation_.stiffness, equation_.damping, p * equation_.force},
          {p * start_.position + q * start_.velocity, p * start_.velocity + q * start_acceleration_}};
}

double LinearMotion::root_between(double level, double from, double to) const {
  std::uintmax_t iterations = 200;
  const auto bracket =
      boost::math::tools::toms748_solve([this, level](double time) { return at(time).position - level; },
                                        from, to, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace grainproof::analytic
