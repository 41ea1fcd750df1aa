// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <limits>

#include "reference_cpu/touch.hpp"

namespace grainproof::reference {

/// The first evaluation: all but dashpots, and but friction that is one.
template <bool turning>
class SpringTouch : protected AnyTouch<turning, true, NoLog> {
  using Base = AnyTouch<turning, true, NoLog>;

 public:
  static constexpr bool cohesive = true;
  using Base::Base;

  Vec3 force_on_second(const PairLaws& laws, const Encounter& meet, const Vec3& relative_velocity,
                       double effective_mass) {
    Vec3 force = attraction(laws, meet, this->log_);
    if (meet.overlap > 0.0)
      force += contact(
          laws, meet,
          {meet.normal, meet.overlap, relative_velocity, effective_mass, this->effective_radius(meet)});
    return force;
  }

 private:
  Vec3 contact(const PairLaws& laws, const Encounter& meet, ContactPoint point) {
    TorqueArms arms;
    if constexpr (turning) {
      arms = this->arms_of(laws, meet);
      point.relative_velocity -= this->sweep(meet, arms).cross(meet.normal);
    }
    ContactSprings springs;
    if (laws.remembers()) springs = this->history_.recall(this->memory_key(meet), meet.second);
    const ContactResponse now = response(laws, point, std::sqrt(point.effective_mass));
    const Vec3 friction = stretched(laws, point, now, springs);
    if constexpr (turning) {
      this->twist(meet, arms, meet.normal.cross(friction));
      if (laws.rolling.present()) roll(laws, meet, arms, point, springs);
    }
    if (laws.remembers()) this->history_.keep(this->memory_key(meet), meet.second, springs);
    return now.push * meet.normal + friction;
  }

  /// What dashpots will add decides whether a spring slides, so that no limit can be known yet.
  Vec3 stretched(const PairLaws& laws, const ContactPoint& point, const ContactResponse& now,
                 ContactSprings& springs) const {
    if (!laws.spring.present()) return Vec3::Zero();
    const Vec3 slip = point.relative_velocity - point.relative_velocity.dot(point.normal) * point.normal;
    return spring_friction(laws, point, slip, std::numeric_limits<double>::infinity(),
                           {now.shear.stiffness, 0.0}, slip * this->history_.elapsed(), springs);
  }

  void roll(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms, const ContactPoint& point,
            ContactSprings& springs) {
    this->resist_rolling(laws, meet, this->rolling_spin(laws, meet, arms), point,
                         std::numeric_limits<double>::infinity(), this->history_.elapsed(), springs);
  }
};

/// The second: everything, with the velocities that the first one foretells.
template <bool turning, class Log>
class DashpotTouch : protected AnyTouch<turning, true, Log> {
  using Base = AnyTouch<turning, true, Log>;

 public:
  static constexpr bool cohesive = true;

  DashpotTouch(const Walls& walls, Bodies& bodies, ContactHistory& history, Log& log, double step)
      : Base(walls, bodies, history, log), half_step_(0.5 * step) {}

  Vec3 force_on_second(const PairLaws& laws, const Encounter& meet, const Vec3& relative_velocity,
                       double effective_mass) {
    Vec3 force = attraction(laws, meet, this->log_);
    if (meet.overlap > 0.0)
      force += contact(
          laws, meet,
          {meet.normal, meet.overlap, relative_velocity, effective_mass, this->effective_radius(meet)});
    return force;
  }

 private:
  /// Of a velocity, what a dashpot leaves of it in half a step by itself.
  double left_by(double damping, double inverse_mass) const {
    return 1.0 / (1.0 + half_step_ * damping * inverse_mass);
  }

  Vec3 contact(const PairLaws& laws, const Encounter& meet, ContactPoint point) {
    TorqueArms arms;
    if constexpr (turning) {
      arms = this->arms_of(laws, meet);
      point.relative_velocity -= this->sweep(meet, arms).cross(meet.normal);
    }
    ContactSprings springs;
    if (laws.remembers()) springs = this->history_.recall(this->memory_key(meet), meet.second);
    const ContactForce force = implicit_force(laws, meet, arms, point, springs);
    if constexpr (turning) {
      this->twist(meet, arms, meet.normal.cross(force.friction));
      if (laws.rolling.present())
        this->resist_rolling(laws, meet, this->rolling_spin(laws, meet, arms), point, force.normal, 0.0,
                             springs);
    }
    if (laws.remembers()) this->history_.keep(this->memory_key(meet), meet.second, springs);
    this->log_.contact(laws, meet, arms, point, force, springs);
    return force.normal * meet.normal + force.friction;
  }

  ContactForce implicit_force(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                              ContactPoint point, ContactSprings& springs) const {
    const double root_mass = std::sqrt(point.effective_mass);
    const double across = inverse_sliding_mass(meet, arms, point);
    ContactResponse now = response(laws, point, root_mass);
    const double damping = now.damping;
    now.damping *= left_by(damping, 1.0 / point.effective_mass);
    now.shear.damping *= left_by(now.shear.damping, across);
    const double holding = laws.friction.per_speed(damping, root_mass);
    if (!laws.spring.present() && std::isfinite(holding))  // dynamic friction is no dashpot
      slow_slip(point, left_by(holding, across));
    const auto stays = [](const Vec3&) -> Vec3 { return Vec3::Zero(); };
    return contact_force(laws, point, now, damping, root_mass, stays, springs);
  }

  static void slow_slip(ContactPoint& point, double left) {
    const Vec3 along = point.relative_velocity.dot(point.normal) * point.normal;
    point.relative_velocity = along + left * (point.relative_velocity - along);
  }

  /// The inverse of what resists a change of the slip, 1/kg.
  double inverse_sliding_mass(const Encounter& meet, const TorqueArms& arms,
                              const ContactPoint& point) const {
    double inverse = 1.0 / point.effective_mass;
    if constexpr (turning) {
      const auto& spins = this->bodies_.spin;
      inverse += arms.second * arms.second * spins[meet.second].inverse_inertia;
      if (!meet.with_wall()) inverse += arms.first * arms.first * spins[meet.first].inverse_inertia;
    }
    return inverse;
  }

  double half_step_;
};

}  // namespace grainproof::reference
