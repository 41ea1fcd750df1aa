// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/onset/boundary_touch.hpp"

namespace grainproof::reference {

// The velocities before the step are twice those in its middle less those predicted for its end.
template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
BeforeParting BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::before_parting(
    const PairLaws& laws, const Encounter& meet, const TorqueArms& arms, double effective_mass) const {
  const Bodies& bodies = this->bodies_;
  const Vec3 half = bends(laws) ? half_step_velocity_by_then<turning>(bodies, meet, arms, now_.step)
                                : half_step_velocity<turning>(bodies, meet, arms);
  Vec3 predicted = bodies.body[meet.second].velocity;
  predicted -= meet.with_wall() ? meet.wall_velocity : bodies.body[meet.first].velocity;
  Vec3 rolling = Vec3::Zero();
  if constexpr (turning) {
    predicted -= this->sweep(meet, arms).cross(meet.normal);
    if (laws.rolling.present()) {
      Vec3 spin = 2.0 * bodies.half_spin[meet.second];
      if (!meet.with_wall()) spin -= 2.0 * bodies.half_spin[meet.first];
      spin -= bodies.spin[meet.second].angular_velocity;
      spin += meet.with_wall() ? -this->spin_of_first(meet) : this->spin_of_first(meet);
      rolling = this->as_rolling(laws, meet, arms, spin);
    }
  }
  const Vec3 velocity = 2.0 * half - predicted;
  const double overlap = std::max(meet.overlap + now_.step * half.dot(meet.normal), 0.0);
  const ContactPoint point{meet.normal, overlap, velocity, effective_mass, this->effective_radius(meet)};
  const Vec3 slip = slip_at(point);
  return {point, slip, in_plane(predicted, meet.normal) - slip, rolling};
}

template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
void BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::end(const PairLaws& laws,
                                                                     const Encounter& meet,
                                                                     double effective_mass,
                                                                     ContactSprings springs) {
  TorqueArms arms;
  if constexpr (turning) arms = this->arms_of(laws, meet);
  const BeforeParting before = before_parting(laws, meet, arms, effective_mass);
  add_ending(laws, meet, arms, before, springs);
}

template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
void BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::add_ending(const PairLaws& laws,
                                                                            const Encounter& meet,
                                                                            const TorqueArms& arms,
                                                                            const BeforeParting& before,
                                                                            ContactSprings springs) {
  // Laid into the tangent plane of now, as everything about the contact is; as long as it was then.
  if (laws.spring.present()) springs.displacement = laws.spring.turned(springs.displacement, meet.normal);
  springs.overlap = 0.0;
  const ContactPoint& point = before.point;
  const double step = now_.step, half = 0.5 * step;
  const double rate = -point.relative_velocity.dot(point.normal);
  const PartialContact contact(laws, point, step);
  if (laws.normal.no_tension && contact.force_at({point.overlap, rate}) <= 0.0) return;
  const PartialPush push = contact.ending({point.overlap, rate});
  const ShearShare share = laws.hertz.present() ? hertz_shear_of_an_ending : ShearShare{};
  const Vec3 rub = bends(laws)
                       ? rub_to_the_end(laws, meet, arms, before, springs.displacement, push.lasted)
                       : friction_impulse(laws, point, before.slip, springs.displacement, push, share);
  const ContactForce force = contact_force(laws, point, 0.0, springs);
  OnsetEvent event{meet, arms, (push.impulse - half * force.normal) * meet.normal,
                   rub - half * force.friction,
                   (push.moment - step * half * force.normal) * meet.normal +
                       (step - 0.5 * push.lasted) * rub - (step * half) * force.friction};
  if (laws.rolling.present())
    event.resist = resist_to_the_end(laws, point, before.rolling, force, push, springs);
  event.centre = this->bodies_.body[meet.second].position;
  events_.add(event);
}

template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
auto BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::pass_zero(const PairLaws& laws,
                                                                           Encounter meet, TorqueArms arms,
                                                                           ContactPoint point,
                                                                           ContactSprings springs)
    -> Crossing {
  const double usual = this->history_.elapsed();
  const BeforeParting before = before_parting(laws, meet, arms, point.effective_mass);
  const auto force_of = [&](const ContactPoint& at) {
    return PartialContact(laws, at, now_.step).force_at({at.overlap, -at.relative_velocity.dot(at.normal)});
  };
  const double then = force_of(before.point), now = force_of(point);
  if ((then > 0.0) == (now > 0.0)) return {.elapsed = usual, .springs = springs, .passed = false};
  const double since = now_.step * now / (now - then);
  if (laws.normal.no_tension && then > 0.0) add_ending(laws, meet, arms, before, springs);
  if (!laws.spring.present()) return {usual, springs, true};
  springs.rolling_torque.setZero();
  if (bends(laws) && !laws.normal.no_tension)
    return follow_through_zero(laws, meet, arms, point, before, now, springs);
  springs.displacement.setZero();
  if (laws.spring.limit == CoulombLimit::spring_and_dashpot) {
    const ShearResponse shear = response(laws, point, std::sqrt(point.effective_mass)).shear;
    springs.displacement = slip_at(point) * (-shear.damping / shear.stiffness);
  }
  return {since, springs, true};
}

/// What is left of rolling resistance, less what the plain scheme has taken of it. A constant torque falls
/// with the overlap, a spring's does not.
template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
Vec3 BoundaryTouch<turning, is_cohesive, corrects, Memory, Log>::resist_to_the_end(
    const PairLaws& laws, const ContactPoint& point, const Vec3& rolling, const ContactForce& force,
    const PartialPush& push, ContactSprings springs) const {
  const Vec3 plain = rolling_torque(laws, point, rolling, force.normal, 0.0, springs);
  if (!laws.rolling.spring) return (0.5 * push.lasted - 0.5 * now_.step) * plain;
  const Vec3 mean = rolling_torque(laws, point, rolling, push.mean_magnitude, 0.5 * push.lasted, springs);
  return push.lasted * mean - 0.5 * now_.step * plain;
}

}  // namespace grainproof::reference
