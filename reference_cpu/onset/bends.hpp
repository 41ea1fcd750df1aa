// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/onset/boundary_touch.hpp"
#include "reference_cpu/onset/damped_flow.hpp"

/// Where the Coulomb limit takes hold of spring and dashpot within a step, friction bends, and the trapezoid
/// rule misses a part of the second order (integrators.21).
namespace grainproof::reference {

/// By how much the velocity that a dashpot is told differs from the true one: so much of the predicted
/// velocity, so much of that before the step. It changes evenly, so that it was the same at the step's start.
struct Foretold {
  double of_now, of_before;
};

inline Foretold foretold(double stiffness, double damping, double inverse_mass, double step) {
  const double twice = 0.5 * step * inverse_mass, c = twice * damping, kappa = twice * step * stiffness;
  return {(1.0 + c) / (1.0 + c + kappa) - (1.0 - 0.5 * kappa) / (1.0 + c), (0.5 * kappa - c) / (1.0 + c)};
}

template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
Grip BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::grip_before(
    const PairLaws& laws, const Encounter& meet, const TorqueArms& arms, const ContactPoint& point,
    const BeforeParting& before, const Vec3& held) const {
  const ContactResponse then = linear_response(laws, before.point, std::sqrt(point.effective_mass));
  const double rate = -before.point.relative_velocity.dot(point.normal);
  const double rate_now = -point.relative_velocity.dot(point.normal);
  const Foretold n = foretold(laws.normal.stiffness, then.damping, inverse_mass(meet), now_.step);
  double push = then.push + then.damping * (rate + n.of_now * rate_now + n.of_before * rate);
  if (laws.normal.no_tension) push = std::max(push, 0.0);
  const Foretold t =
      foretold(then.shear.stiffness, then.shear.damping, inverse_sliding_mass(meet, arms), now_.step);
  const Vec3 slip = before.slip + t.of_now * slip_at(point) + t.of_before * before.slip;
  return {then.shear.stiffness * held + then.shear.damping * slip, laws.spring.coefficient * std::abs(push)};
}

/// A contact that slid all along has no room left, but for round-off and what is of higher order.
template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
void BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::add_bend(const PairLaws& laws,
                                                                          Encounter meet, TorqueArms arms,
                                                                          ContactPoint point, Vec3 held,
                                                                          Vec3 stretched, ShearResponse shear,
                                                                          double normal) {
  constexpr double least_share = 1e-3;
  const BeforeParting before = before_parting(laws, meet, arms, point.effective_mass);
  const Grip then = grip_before(laws, meet, arms, point, before, held);
  const Vec3 pull = shear.stiffness * stretched + shear.damping * slip_at(point);
  const double length = pull.norm(), excess = length - laws.spring.coefficient * std::abs(normal);
  const Vec3 along = pull / length;
  const double room = then.most - std::copysign(then.pull.norm(), then.pull.dot(along));
  if (!(room > least_share * excess)) return;
  OnsetEvent event{meet, arms};
  event.rub = along * (-0.5 * now_.step * room * excess / (room + excess));
  event.centre = this->bodies_.body[meet.second].position;
  events_.add(event);
}

/// When a force that goes from `first` to `last` in a step passes zero, its second derivative being the same
/// all along.
inline double time_to_zero(double first, double last, double second_derivative, double step) {
  const double slope = (last - first) / step - 0.5 * step * second_derivative;
  const double slope_there = std::sqrt(std::max(slope * slope - 2.0 * second_derivative * first, 0.0));
  const double time = 2.0 * std::abs(first) / (slope_there - (first > 0.0 ? slope : -slope));
  return time > 0.0 ? std::min(time, step) : 0.0;
}

/// From the slip when the normal force, which comes to `last`, passes zero.
template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
auto BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::follow_through_zero(
    const PairLaws& laws, const Encounter& meet, const TorqueArms& arms, const ContactPoint& point,
    const BeforeParting& before, double last, ContactSprings springs) const -> Crossing {
  const ContactResponse then = linear_response(laws, before.point, std::sqrt(point.effective_mass));
  const double rate = -before.point.relative_velocity.dot(point.normal),
               mobility = inverse_sliding_mass(meet, arms);
  const double force = then.push + then.damping * rate;
  const double change = laws.normal.stiffness * rate - then.damping * force / point.effective_mass;
  const double bend = -(laws.normal.stiffness * force + then.damping * change) / point.effective_mass;
  const double until = time_to_zero(force, last, bend, now_.step);
  const Grip grip = grip_before(laws, meet, arms, point, before, carried(laws, meet, springs.displacement));
  const Vec3 held =
      grip.pull.norm() > grip.most ? (grip.pull * (grip.most / grip.pull.norm())).eval() : grip.pull;
  const Vec3 growth = then.shear.stiffness * (before.slip + 0.5 * before.gain) +
                      (then.shear.damping / now_.step) * before.gain;
  const Vec3 rub = limited_impulse(held, held + until * growth, grip.most, 0.0, until);
  const double since = now_.step - until;
  // By all but this friction: other forces, and spheres that roll round each other.
  const Vec3 drift = before.gain / now_.step + mobility * held;
  const Vec3 slip = before.slip + until * drift + mobility * rub;
  springs.displacement = slip * (-then.shear.damping / then.shear.stiffness);
  const double slowed = 1.0 - 0.5 * then.shear.stiffness * mobility * since * since;
  return {since, springs, true, true, slowed * slip + since * drift, rub + (0.5 * now_.step) * held};
}

/// Friction at the boundary is that of a contact which has gripped anew.
template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
void BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::follow(const PairLaws& laws,
                                                                        const Crossing& crossing,
                                                                        ContactPoint& point,
                                                                        ContactResponse& now) {
  point.relative_velocity = point.relative_velocity.dot(point.normal) * point.normal + crossing.slip;
  now.shear = linear_response(laws, point, std::sqrt(point.effective_mass)).shear;
}

template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
void BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::add_turnover(const Encounter& meet,
                                                                              const TorqueArms& arms,
                                                                              const Crossing& crossing,
                                                                              const Vec3& friction) {
  OnsetEvent event{meet, arms};
  event.rub = crossing.rub + (0.5 * (crossing.elapsed - now_.step)) * friction;
  event.centre = this->bodies_.body[meet.second].position;
  events_.add(event);
}

/// In two parts where the normal force passes zero before the end.
template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
Vec3 BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::rub_to_the_end(
    const PairLaws& laws, const Encounter& meet, const TorqueArms& arms, const BeforeParting& before,
    const Vec3& spring, double lasted) const {
  const ContactPoint& point = before.point;
  const ContactResponse then = linear_response(laws, point, std::sqrt(point.effective_mass));
  const NormalState left{point.overlap, -point.relative_velocity.dot(point.normal)};
  const DampedFlow motion(laws.normal.stiffness, then.damping, point.effective_mass);
  const NormalState parted = motion.after(left, lasted);
  double first = then.push + then.damping * left.rate;
  double last = laws.normal.stiffness * parted.overlap + then.damping * parted.rate;
  if (laws.normal.no_tension) first = std::max(first, 0.0), last = std::max(last, 0.0);
  const Vec3 pull = then.shear.stiffness * spring + then.shear.damping * before.slip;
  const Vec3 growth = then.shear.stiffness * before.slip + (then.shear.damping / now_.step) * before.gain;
  const double share = laws.spring.coefficient;
  if (!(first > 0.0 && last < 0.0))
    return limited_impulse(pull, pull + lasted * growth, share * std::abs(first), share * std::abs(last),
                           lasted);
  const double change = laws.normal.stiffness * left.rate - then.damping * first / point.effective_mass;
  const double until = std::min(motion.time_to_part({first, change}), lasted), rest = lasted - until;
  const Vec3 rub = limited_impulse(pull, pull + until * growth, share * first, 0.0, until);
  const Vec3 slip = before.slip + inverse_sliding_mass(meet, arms) * rub;
  return rub + limited_impulse(Vec3::Zero(), (then.shear.stiffness * rest) * slip, 0.0, -share * last, rest);
}

}  // namespace grainproof::reference
