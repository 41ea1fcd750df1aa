// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/onset/boundary_touch.hpp"

namespace grainproof::reference {

/// Bodies may slide from the very touch on, at which a dashpot pushes already: the spring is then what
/// makes it and its own dashpot add up to the limit. A Hertz contact has no dashpot there.
template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
Vec3 BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::spring_at_touch(const PairLaws& laws,
                                                                                 const ContactPoint& point,
                                                                                 const Vec3& slip,
                                                                                 double rate) {
  Vec3 spring = Vec3::Zero();
  if (!laws.spring.present() || laws.hertz.present()) return spring;
  const ContactResponse now = response(laws, point, std::sqrt(point.effective_mass));
  laws.spring.force(spring, slip, now.damping * rate, now.shear);
  return spring;
}

template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
Vec3 BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::begin(const PairLaws& laws, Encounter meet,
                                                                       TorqueArms arms, ContactPoint point) {
  const Vec3 slip = slip_at(point);
  const double rate = -half_step_velocity<turning>(this->bodies_, meet, arms).dot(meet.normal);
  const auto [state, push] = PartialContact(laws, point, now_.step).beginning({meet.overlap, rate});
  Vec3 slip_then = slip;  // at the touch
  if (bends(laws))
    slip_then -= (push.lasted / now_.step) * before_parting(laws, meet, arms, point.effective_mass).gain;
  const Vec3 spring = spring_at_touch(laws, point, slip_then, meet.overlap / push.lasted);
  point.overlap = state.overlap;
  const ShearShare share = laws.hertz.present() ? hertz_shear_of_a_beginning : ShearShare{};
  const Vec3 rub = friction_impulse(laws, point, slip, spring, push, share);
  const Vec3 slip_now = slip + rub * inverse_sliding_mass(meet, arms);
  point.relative_velocity = slip_now - state.rate * meet.normal;
  ContactSprings springs{.displacement = spring + (slip_then + slip_now) * (0.5 * push.lasted)};
  const ContactForce force = contact_force(laws, point, 0.0, springs);
  const double half = 0.5 * now_.step;
  OnsetEvent event{meet, arms, (push.impulse - half * force.normal) * meet.normal,
                   rub - half * force.friction, push.moment * meet.normal + (0.5 * push.lasted) * rub};
  if constexpr (turning) {
    this->twist(meet, arms, meet.normal.cross(force.friction));
    // Grows from nothing with the overlap or the turn.
    if (laws.rolling.present())
      event.resist =
          (0.5 * push.lasted - half) * this->resist_rolling(laws, meet, winding_spin(laws, meet, arms), point,
                                                            force.normal, push.lasted, springs);
  }
  event.centre = this->bodies_.body[meet.second].position;
  events_.add(event);
  this->log_.contact(laws, meet, arms, point, force, springs);
  keep(laws, meet, springs);
  return force.normal * meet.normal + force.friction;
}

}  // namespace grainproof::reference
