// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/onset/damped_flow.hpp"

#include <cmath>
#include <limits>

namespace grainproof::reference {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

DampedFlow::DampedFlow(double stiffness, double damping, double mass)
    : mass_(mass), decay_(0.5 * damping / mass), square_(stiffness / mass) {
  const double difference = square_ - decay_ * decay_;
  rate_ = std::sqrt(std::abs(difference));
  kind_ = difference > 0.0 ? Kind::vibrates : difference < 0.0 ? Kind::creeps : Kind::critical;
}

// cosine' = ∓ rate² sine and sine' = cosine, whatever the kind.
NormalState DampedFlow::after(const NormalState& start, double time) const {
  const double angle = rate_ * time;
  double cosine = 1.0, sine = time;
  if (kind_ == Kind::vibrates) cosine = std::cos(angle), sine = std::sin(angle) / rate_;
  if (kind_ == Kind::creeps) cosine = std::cosh(angle), sine = std::sinh(angle) / rate_;
  const double left = std::exp(-decay_ * time);
  return {left * (start.overlap * cosine + (start.rate + decay_ * start.overlap) * sine),
          left * (start.rate * cosine - (decay_ * start.rate + square_ * start.overlap) * sine)};
}

double DampedFlow::time_to_part(const NormalState& start) const {
  if (start.overlap <= 0.0) return 0.0;
  const double slope = start.rate + decay_ * start.overlap;
  if (kind_ == Kind::vibrates) return std::atan2(start.overlap * rate_, -slope) / rate_;
  if (slope >= 0.0) return never;
  if (kind_ == Kind::critical) return -start.overlap / slope;
  const double ratio = -start.overlap * rate_ / slope;
  return ratio < 1.0 ? std::atanh(ratio) / rate_ : never;
}

}  // namespace grainproof::reference
