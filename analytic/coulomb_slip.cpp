// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/coulomb_slip.hpp"

#include <algorithm>
#include <cmath>

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
    : push_(push), coefficient_(coefficient), speed_(speed) {
  turned_ = pushed(push.force_zero());
  left_ = pulled(push.end());
}

Motion CoulombSlip::at(double time) const {
  if (time <= push_.force_zero()) return pushed(time);
  if (time <= push_.end()) return pulled(time);
  return {left_.position + left_.velocity * (time - push_.end()), left_.velocity};
}

Motion CoulombSlip::pushed(double time) const {
  const Motion gap = push_.gap(time), entry = push_.gap(0.0);
  return {speed_ * time - coefficient_ * (gap.position - entry.velocity * time),
          speed_ - coefficient_ * (gap.velocity - entry.velocity)};
}

Motion CoulombSlip::pulled(double time) const {
  const Motion turn = push_.gap(push_.force_zero()), gap = push_.gap(time);
  const double since = time - push_.force_zero();
  return {turned_.position + turned_.velocity * since -
              coefficient_ * (turn.velocity * since - (gap.position - turn.position)),
          turned_.velocity - coefficient_ * (turn.velocity - gap.velocity)};
}

}  // namespace grainproof::analytic
