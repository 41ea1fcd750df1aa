// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/coulomb_slip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analytic/contact_scales.hpp"

namespace grainproof::analytic {
namespace {

LinearMotion gap_of(const Encounter& e, double entry_speed) {
  const LinearNormal& law = e.normal_law();
  return {{e.mass, law.stiffness, damping(law, e.mass), 0.0}, {0.0, -entry_speed}};
}

}  // namespace

Push::Push(const Encounter& e, const Passage::Contact& contact)
    : gap_(gap_of(e, contact.entry_speed)),
      force_(gap_.combined(-e.normal_law().stiffness, -damping(e.normal_law(), e.mass))),
      force_zero_(std::min(force_.first_time_at(0.0).value_or(*contact.end), *contact.end)),
      end_(e.normal_law().no_tension ? force_zero_ : *contact.end) {}

double Push::largest_force() const {
  double largest = std::max(std::abs(force_.start().position), std::abs(force_.at(end_).position));
  if (const auto turn = force_.turning_time(); turn && *turn < end_)
    largest = std::max(largest, std::abs(force_.at(*turn).position));
  return largest;
}

CoulombSlip::CoulombSlip(const Push& push, double coefficient, double speed)
    : CoulombSlip([push](double time) { return push.gap(time); }, push.force_zero(), push.end(), coefficient,
                  speed) {}

CoulombSlip::CoulombSlip(std::function<Motion(double)> gap, double force_zero, double end, double coefficient,
                         double speed)
    : gap_(std::move(gap)), force_zero_(force_zero), end_(end), coefficient_(coefficient), speed_(speed) {
  turned_ = pushed(force_zero_);
  left_ = pulled(end_);
}

Motion CoulombSlip::at(double time) const {
  if (time <= force_zero_) return pushed(time);
  if (time <= end_) return pulled(time);
  return {left_.position + left_.velocity * (time - end_), left_.velocity};
}

Motion CoulombSlip::pushed(double time) const {
  const Motion gap = gap_(time), entry = gap_(0.0);
  return {speed_ * time - coefficient_ * (gap.position - entry.velocity * time),
          speed_ - coefficient_ * (gap.velocity - entry.velocity)};
}

Motion CoulombSlip::pulled(double time) const {
  const Motion turn = gap_(force_zero_), gap = gap_(time);
  const double since = time - force_zero_;
  return {turned_.position + turned_.velocity * since -
              coefficient_ * (turn.velocity * since - (gap.position - turn.position)),
          turned_.velocity - coefficient_ * (turn.velocity - gap.velocity)};
}

}  // namespace grainproof::analytic
