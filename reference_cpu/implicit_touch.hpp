// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <limits>

#include "reference_cpu/touch.hpp"

namespace grainproof::reference {

/// What both evaluations do with a contact; `Evaluation` says its force, and how rolling is resisted with it.
template <class Evaluation, bool turning, class Log>
class ImplicitTouch : protected AnyTouch<turning, true, Log> {
 public:
  static constexpr bool cohesive = true;
  using AnyTouch<turning, true, Log>::AnyTouch;

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
    auto& evaluation = static_cast<Evaluation&>(*this);
    TorqueArms arms;
    if constexpr (turning) {
      arms = this->arms_of(laws, meet);
      point.relative_velocity -= this->sweep(meet, arms).cross(meet.normal);
    }
    ContactSprings springs;
    if (laws.remembers()) springs = this->history_.recall(this->memory_key(meet), meet.second);
    const ContactForce force = evaluation.force_of(laws, meet, arms, point, springs);
    if constexpr (turning) {
      this->twist(meet, arms, meet.normal.cross(force.friction));
      if (laws.rolling.present())
        this->resist_rolling(laws, meet, this->rolling_spin(laws, meet, arms), point,
                             evaluation.holding(force), evaluation.elapsed(), springs);
    }
    if (laws.remembers()) this->history_.keep(this->memory_key(meet), meet.second, springs);
    this->log_.contact(laws, meet, arms, point, force, springs);
    return force.normal * meet.normal + force.friction;
  }
};

/// The first evaluation: all but dashpots, and but friction that is one.
template <bool turning>
class SpringTouch : public ImplicitTouch<SpringTouch<turning>, turning, NoLog> {
  using Base = ImplicitTouch<SpringTouch<turning>, turning, NoLog>;
  friend Base;

 public:
  using Base::Base;

 private:
  /// What dashpots will add decides whether a spring slides, so that no limit can be known yet.
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  double holding(const ContactForce&) const { return unlimited; }
  double elapsed() const { return this->history_.elapsed(); }

  ContactForce force_of(const PairLaws& laws, const Encounter&, const TorqueArms&, const ContactPoint& point,
                        ContactSprings& springs) const {
    const ContactResponse now = response(laws, point, std::sqrt(point.effective_mass));
    return {now.push, stretched(laws, point, now, springs)};
  }

  Vec3 stretched(const PairLaws& laws, const ContactPoint& point, const ContactResponse& now,
                 ContactSprings& springs) const {
    if (!laws.spring.present()) return Vec3::Zero();
    const Vec3 slip = point.relative_velocity - point.relative_velocity.dot(point.normal) * point.normal;
    return spring_friction(laws, point, slip, unlimited, {now.shear.stiffness, 0.0}, slip * elapsed(),
                           springs);
  }
};

/// The second: everything, with the velocities that the first one foretells. It winds no spring again.
template <bool turning, class Log>
class DashpotTouch : public ImplicitTouch<DashpotTouch<turning, Log>, turning, Log> {
  using Base = ImplicitTouch<DashpotTouch<turning, Log>, turning, Log>;
  friend Base;

 public:
  DashpotTouch(const Walls& walls, Bodies& bodies, ContactHistory& history, Log& log, double step)
      : Base(walls, bodies, history, log), half_step_(0.5 * step) {}

 private:
  double holding(const ContactForce& force) const { return force.normal; }
  double elapsed() const { return 0.0; }

  /// Of a velocity, what a dashpot leaves of it in half a step by itself.
  double left_by(double damping, double inverse_mass) const {
    return 1.0 / (1.0 + half_step_ * damping * inverse_mass);
  }

  ContactForce force_of(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
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
    const auto of_spring = [&](const Vec3& slip, double normal) {
      return spring_friction(laws, point, slip, normal, now.shear, Vec3::Zero(), springs);
    };
    return contact_force(laws, point, now, damping, root_mass, of_spring);
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
