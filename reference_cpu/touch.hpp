// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Geometry>

#include "reference_cpu/bodies.hpp"
#include "reference_cpu/contact_force.hpp"
#include "reference_cpu/contact_history.hpp"
#include "reference_cpu/encounter.hpp"
#include "reference_cpu/walls.hpp"

/// What bodies that are near each other do to each other. The loops over pairs and walls are told
/// which of these to use, so that scenes pay for no more than they have.
namespace grainproof::reference {

template <class Log>
Vec3 attraction(const PairLaws& laws, const Encounter& meet, Log& log) {
  if (laws.cohesion.stiffness == 0.0 || meet.effect_overlap <= 0.0) return Vec3::Zero();
  log.attraction(laws, meet.effect_overlap);
  return laws.cohesion.force(meet.effect_overlap) * meet.normal;
}

/// Linear springs, friction without memory, nothing turns.
template <bool is_cohesive, class Log>
class SimpleTouch {
 public:
  static constexpr bool cohesive = is_cohesive;

  explicit SimpleTouch(Log& log) : log_(log) {}

  Vec3 force_on_second(const PairLaws& laws, const Encounter& meet, const Vec3& relative_velocity,
                       double effective_mass) {
    Vec3 force = Vec3::Zero();
    if (meet.overlap > 0.0) {
      const ContactPoint point{meet.normal, meet.overlap, relative_velocity, effective_mass, 0.0};
      const ContactForce contact = contact_force(laws, point);
      force = contact.normal * meet.normal + contact.friction;
      log_.contact(laws, meet, {}, point, contact, {});
    }
    if constexpr (cohesive) force += attraction(laws, meet, log_);
    return force;
  }

 private:
  Log& log_;
};

/// Any laws; torques go straight to the bodies.
template <bool turning, bool is_cohesive, class Log>
class AnyTouch {
 public:
  static constexpr bool cohesive = is_cohesive;

  AnyTouch(const Walls& walls, Bodies& bodies, ContactHistory& history, Log& log)
      : walls_(walls), bodies_(bodies), history_(history), log_(log) {}

  Vec3 force_on_second(const PairLaws& laws, const Encounter& meet, const Vec3& relative_velocity,
                       double effective_mass) {
    Vec3 force = Vec3::Zero();
    if (meet.overlap > 0.0)
      force = contact(laws, meet,
                      {meet.normal, meet.overlap, relative_velocity, effective_mass, effective_radius(meet)});
    if constexpr (cohesive) force += attraction(laws, meet, log_);
    return force;
  }

 protected:
  Vec3 contact(const PairLaws& laws, const Encounter& meet, ContactPoint point) {
    TorqueArms arms;
    if constexpr (turning) {
      arms = arms_of(laws, meet);
      point.relative_velocity -= sweep(meet, arms).cross(meet.normal);
    }
    ContactSprings springs;
    if (laws.remembers()) springs = history_.recall(memory_key(meet), meet.second);
    const ContactForce force = contact_force(laws, point, history_.elapsed(), springs);
    if constexpr (turning) {
      twist(meet, arms, meet.normal.cross(force.friction));
      if (laws.rolling.present())
        resist_rolling(laws, meet, rolling_spin(laws, meet, arms), point, force.normal, history_.elapsed(),
                       springs);
    }
    if (laws.remembers()) history_.keep(memory_key(meet), meet.second, springs);
    log_.contact(laws, meet, arms, point, force, springs);
    return force.normal * meet.normal + force.friction;
  }

  std::int32_t memory_key(const Encounter& meet) const {
    return meet.with_wall() ? static_cast<std::int32_t>(bodies_.size()) - 1 - meet.first : meet.first;
  }

  double effective_radius(const Encounter& meet) const {
    const double two = bodies_.body[meet.second].radius;
    if (meet.with_wall()) return two;
    const double one = bodies_.body[meet.first].radius;
    return one * two / (one + two);
  }

  TorqueArms arms_of(const PairLaws& laws, const Encounter& meet) const {
    const double shorter = laws.arm_shortening * meet.overlap;
    return {meet.with_wall() ? 0.0 : bodies_.body[meet.first].radius - shorter,
            bodies_.body[meet.second].radius - shorter};
  }

  /// a1 ω1 + a2 ω2: its cross product with n is how fast turning carries body 1's surface past body 2's.
  Vec3 sweep(const Encounter& meet, const TorqueArms& arms) const {
    Vec3 sum = arms.second * bodies_.spin[meet.second].angular_velocity;
    if (!meet.with_wall()) sum += arms.first * bodies_.spin[meet.first].angular_velocity;
    return sum;
  }

  /// (−a2 n) × F_t on body 2 and (a1 n) × (−F_t) on body 1 have the same sign: friction turns both alike.
  void twist(const Encounter& meet, const TorqueArms& arms, const Vec3& normal_cross_friction) {
    bodies_.angular_acceleration[meet.second] -= arms.second * normal_cross_friction;
    if (!meet.with_wall()) bodies_.angular_acceleration[meet.first] -= arms.first * normal_cross_friction;
  }

  const Vec3& spin_of_first(const Encounter& meet) const {
    return meet.with_wall() ? walls_[wall_of(meet)].spin : bodies_.spin[meet.first].angular_velocity;
  }

  /// Of body 2 over body 1. With the shorter arm at a wall it is taken as LIGGGHTS does: from the speed at
  /// that arm over the distance from the wall (docs/laws/rolling.md).
  Vec3 rolling_spin(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms) const {
    return as_rolling(laws, meet, arms, bodies_.spin[meet.second].angular_velocity - spin_of_first(meet));
  }

  Vec3 as_rolling(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                  const Vec3& spin) const {
    if (!meet.with_wall() || laws.arm_shortening == 0.0) return spin;
    return spin * (arms.second / (bodies_.body[meet.second].radius - meet.overlap));
  }

  /// The torque on body 2 against `spin`, that of body 2 over body 1.
  Vec3 resist_rolling(const PairLaws& laws, const Encounter& meet, const Vec3& spin,
                      const ContactPoint& point, double normal_force, double elapsed,
                      ContactSprings& springs) {
    const Vec3 torque = rolling_torque(laws, point, spin, normal_force, elapsed, springs);
    bodies_.angular_acceleration[meet.second] += torque;
    if (!meet.with_wall()) bodies_.angular_acceleration[meet.first] -= torque;
    log_.rolling(meet, torque, spin_of_first(meet));
    return torque;
  }

  const Walls& walls_;
  Bodies& bodies_;
  ContactHistory& history_;
  Log& log_;
};

}  // namespace grainproof::reference
