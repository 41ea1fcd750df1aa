// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>

namespace grainproof::analytic {

struct Motion {
  double position;
  double velocity;
};

/// m x'' = force − damping x' − stiffness x, for any sign of the stiffness: vibration, relaxation,
/// exponential escape and the parabola in one (linear.4). Damping is not negative. Times count from
/// the motion's own start.
class LinearMotion {
 public:
  struct Equation {
    double mass;
    double stiffness;
    double damping;
    double force;
  };

  LinearMotion(const Equation& equation, const Motion& start);

  Motion at(double time) const;
  double acceleration(double time) const;
  const Motion& start() const { return start_; }

  /// First time after 0 at which the velocity is zero; none at rest or where it never is.
  std::optional<double> turning_time() const;

  /// First time after 0 at which the position passes `level`. A start on the level itself does not count.
  std::optional<double> first_time_at(double level) const;

  /// p x + q x', which obeys the same equation with the force p F.
  LinearMotion combined(double p, double q) const;

  /// The same equation from another start.
  LinearMotion restarted(const Motion& start) const { return {equation_, start}; }

 private:
  struct Basis {
    double even;  ///< e^{−βt} cos ωt, or its hyperbolic or polynomial twin
    double odd;   ///< e^{−βt} sin(ωt)/ω
  };
  Basis basis(double time) const;
  double half_period() const;
  std::optional<double> first_on_parabola(double level) const;
  std::optional<double> first_after_last_turn(double level, double from) const;
  double root_between(double level, double from, double to) const;

  Equation equation_;
  Motion start_;
  double beta_;          ///< damping/(2 mass)
  double kappa_;         ///< stiffness/mass
  double discriminant_;  ///< β² − κ
  double frequency_;     ///< sqrt(|β² − κ|)
  double start_acceleration_;
};

}  // namespace grainproof::analytic
