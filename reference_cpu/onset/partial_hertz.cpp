// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/onset/end_error.hpp"
#include "reference_cpu/onset/partial_contact.hpp"

/// Along the straight path δ = u τ, τ counted from the touch, the spring goes with τ^(3/2) and the dashpot
/// with τ^(1/4). The trapezoid rule of all whole steps misses a part of the latter, which is made good here
/// too.
namespace grainproof::reference {
namespace {

constexpr double spring_impulse = 2.0 / 5.0, dashpot_impulse = 4.0 / 5.0;

/// Impulse of a force that has grown to `force` over `lasted` as that power of time, with all that whole
/// steps will miss.
double whole_impulse(double force, double power, double lasted, double step) {
  const double steps = lasted / step;
  return step * force * (0.5 - hurwitz(power, steps) / std::pow(steps, power));
}

}  // namespace

Beginning PartialContact::hertz_beginning(const NormalState& reached, double lasted) const {
  const double mass = point_.effective_mass, rate = reached.overlap / lasted;
  const ContactResponse full = response_at(reached);
  const double dashpot = full.damping * rate;
  const double impulse = lasted * (spring_impulse * full.push + dashpot_impulse * dashpot);
  const double moment =
      lasted * lasted * (spring_impulse * 2.0 / 7.0 * full.push + dashpot_impulse * 4.0 / 9.0 * dashpot);
  const NormalState end{reached.overlap - moment / mass, rate - impulse / mass};
  const double all =
      whole_impulse(full.push, 1.5, lasted, step_) + whole_impulse(dashpot, 0.25, lasted, step_);
  return {end, {lasted, all, moment, std::abs(impulse) / lasted}};
}

PartialPush PartialContact::hertz_ending(const NormalState& left) const {
  const double force = force_at(left);
  const bool parts = left.overlap > 0.0 && -left.rate * step_ > left.overlap;
  if (!parts) return {step_, 0.5 * step_ * force, 0.5 * step_ * step_ * force, std::abs(force)};
  const double lasted = left.overlap / -left.rate;
  const ContactResponse full = response_at(left);
  const double dashpot = full.damping * left.rate;
  const double impulse = lasted * (spring_impulse * full.push + dashpot_impulse * dashpot);
  const double moment = lasted * lasted * (2.0 / 7.0 * full.push + 4.0 / 9.0 * dashpot);
  const double magnitude = std::abs(impulse) / lasted;
  const double all =
      whole_impulse(full.push, 1.5, lasted, step_) + whole_impulse(dashpot, 0.25, lasted, step_);
  return {lasted, all, (step_ - lasted) * impulse + moment, magnitude};
}

}  // namespace grainproof::reference
