// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "analytic/encounter.hpp"
#include "analytic/linear_motion.hpp"
#include "analytic/passage.hpp"

namespace grainproof::analytic {

/// The normal contact that a slip goes through, its times counted from the moment of touching.
class Push {
 public:
  Push(const Encounter& encounter, const Passage::Contact& contact);

  Motion gap(double time) const { return gap_.at(time); }
  double force_zero() const { return force_zero_; }  ///< s; from here a plain dashpot pulls
  double end() const { return end_; }                ///< s; from here no force acts
  double largest_force() const;                      ///< of |F_n|, N

 private:
  LinearMotion gap_, force_;
  double force_zero_, end_;
};

/// Slip path and speed while the Coulomb force μ|F_n| acts and the slip never ends. The impulse of F_n
/// is m times the change of the gap's speed, so both follow from the gap itself (friction.8).
class CoulombSlip {
 public:
  CoulombSlip(const Push& push, double coefficient, double speed);

  /// Through any normal contact that pushes until `force_zero` and acts until `end`.
  CoulombSlip(std::function<Motion(double)> gap, double force_zero, double end, double coefficient,
              double speed);

  Motion at(double time) const;
  double final_speed() const { return left_.velocity; }

 private:
  Motion pushed(double time) const;
  Motion pulled(double time) const;

  std::function<Motion(double)> gap_;
  double force_zero_, end_, coefficient_, speed_;
  Motion turned_{0.0, 0.0}, left_{0.0, 0.0};
};

}  // namespace grainproof::analytic
