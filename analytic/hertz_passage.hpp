// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "analytic/hertz.hpp"
#include "analytic/linear_motion.hpp"

namespace grainproof::analytic {

/// A Hertz contact from gap 0 to gap 0, without gravity (hertz.9). Times count from the onset.
class HertzPassage {
 public:
  HertzPassage(const HertzPair& pair, double speed);

  Motion gap(double time) const;  ///< also after the end
  double duration() const { return duration_; }
  double force_zero() const;  ///< s; from here the dashpot pulls
  double peak_overlap() const;
  double exit_speed() const;
  double largest_force() const;  ///< of an elastic contact, N

 private:
  double time_in(double root) const;
  double time_out(double root) const;
  Motion gap_at(double angle, double from_end) const;
  double root_of(double time, double (HertzPassage::*elapsed)(double) const) const;

  HertzPair pair_;
  double speed_;
  double under_damping_;  ///< sqrt(1 − β²)
  double decay_;          ///< β/sqrt(1 − β²), per radian
  double frequency_;      ///< ω of hertz.9
  double in_, duration_;
};

}  // namespace grainproof::analytic
