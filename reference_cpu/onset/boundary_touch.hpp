// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <type_traits>

#include "reference_cpu/onset/before_step.hpp"
#include "reference_cpu/onset/boundary_step.hpp"
#include "reference_cpu/onset/half_step.hpp"
#include "reference_cpu/onset/partial_contact.hpp"
#include "reference_cpu/touch.hpp"

namespace grainproof::reference {

/// Any laws, evaluated with the velocities predicted for the step boundary. With `corrects`, contacts that
/// begin act for the time they have lasted, and all are remembered: by the history, or where no law keeps
/// anything by the mere fact that they touch.
template <bool turning, bool is_cohesive, bool corrects, class Memory, class Log>
class BoundaryTouch : protected AnyTouch<turning, is_cohesive, Log> {
  using Base = AnyTouch<turning, is_cohesive, Log>;

 public:
  static constexpr bool cohesive = is_cohesive;

  BoundaryTouch(const Walls& walls, Bodies& bodies, ContactHistory& history, Memory& memory, Log& log,
                const BoundaryStep& now, OnsetEvents& events)
      : Base(walls, bodies, history, log), memory_(memory), now_(now), events_(events) {}

  Vec3 force_on_second(const PairLaws& laws, const Encounter& meet, const Vec3& relative_velocity,
                       double effective_mass) {
    Vec3 force = Vec3::Zero();
    if (meet.overlap > 0.0)
      force = contact(laws, meet,
                      {meet.normal, meet.overlap, relative_velocity, effective_mass, radius_for(laws, meet)});
    if constexpr (cohesive) force += attraction(laws, meet, this->log_);
    return force;
  }

  /// A contact that touches no more, with the springs that it left.
  void end(const PairLaws& laws, const Encounter& meet, double effective_mass, ContactSprings springs);

 private:
  /// Only linear springs and friction without memory, so that nothing but the touch is remembered.
  static constexpr bool simple = std::is_same_v<Memory, Touching>;

  /// Where a law asks for it: it is a division, and simple laws don't.
  double radius_for(const PairLaws& laws, const Encounter& meet) const {
    if constexpr (simple) return 0.0;
    const bool asked = !laws.only_springs && (laws.hertz.present() || laws.rolling.present());
    return asked ? this->effective_radius(meet) : 0.0;
  }

  Vec3 contact(const PairLaws& laws, const Encounter& meet, ContactPoint point) {
    TorqueArms arms;
    if constexpr (turning) {
      arms = this->arms_of(laws, meet);
      point.relative_velocity -= this->sweep(meet, arms).cross(meet.normal);
    }
    if constexpr (!corrects)
      if (!laws.remembers()) return last(laws, meet, arms, point, {});
    const ContactSprings* kept = memory_.meet(this->memory_key(meet), meet.second);
    if constexpr (corrects)
      if (!kept && now_.started) [[unlikely]]
        return begin(laws, meet, arms, point);
    if constexpr (simple && corrects) return last_simple(laws, meet, point);
    if constexpr (corrects && !simple)
      if (laws.only_springs && now_.started) return last_sprung(laws, meet, arms, point, *kept);
    return last(laws, meet, arms, point, kept ? *kept : ContactSprings{});
  }

  /// As last() where that is simple: half of its instructions.
  Vec3 last_simple(const PairLaws& laws, const Encounter& meet, const ContactPoint& point) {
    const double root_mass = std::sqrt(point.effective_mass);
    const double eta = laws.normal.damping_for(root_mass), stiffness = laws.normal.stiffness;
    const double separating = point.relative_velocity.dot(point.normal);
    if (laws.normal.no_tension && now_.started) [[unlikely]]
      let_go(laws, meet, point);
    const double refined = eta * refined_share(stiffness, eta, inverse_mass(meet), now_.foresight());
    ContactForce force{laws.normal.force(point.overlap, separating, refined), Vec3::Zero()};
    if (laws.friction.coefficient != 0.0)
      force.friction = laws.friction.force(point.relative_velocity - separating * point.normal, force.normal,
                                           eta, root_mass);
    this->log_.contact(laws, meet, {}, point, force, {});
    memory_.keep(this->memory_key(meet), meet.second, {});
    return force.normal * meet.normal + force.friction;
  }

  [[gnu::noinline]] void let_go(const PairLaws& laws, Encounter meet, ContactPoint point) {
    if (may_let_go(laws, meet, point, response(laws, point, std::sqrt(point.effective_mass))))
      pass_zero(laws, meet, {}, point, {});
  }

  /// As last() where laws have nothing but linear springs and dashpots: what lasts is mostly this.
  Vec3 last_sprung(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                   const ContactPoint& point, const ContactSprings& kept) {
    const double separating = point.relative_velocity.dot(point.normal);
    const Vec3 slip = point.relative_velocity - separating * point.normal;
    ContactResponse now = linear_response(laws, point, std::sqrt(point.effective_mass));
    refine(laws.normal.stiffness, inverse_mass(meet), now);
    refine_shear(meet, arms, now);
    if (may_let_go(laws.normal.stiffness, -separating, inverse_mass(meet), now)) [[unlikely]]
      return last_aside(laws, meet, arms, point, kept);
    ContactForce force{laws.normal.force(point.overlap, separating, now.damping), Vec3::Zero()};
    ContactSprings springs{.displacement = kept.displacement};
    force.friction = friction_over_step(laws, meet, arms, point, slip, force.normal, now.shear, springs);
    if constexpr (turning) this->twist(meet, arms, meet.normal.cross(force.friction));
    this->log_.contact(laws, meet, arms, point, force, springs);
    memory_.keep(this->memory_key(meet), meet.second, springs);
    return force.normal * meet.normal + force.friction;
  }

  [[gnu::noinline]] Vec3 last_aside(const PairLaws& laws, Encounter meet, TorqueArms arms, ContactPoint point,
                                    ContactSprings springs) {
    return last(laws, meet, arms, point, springs);
  }

  /// In the plane of now, of a spring that has lasted through the step.
  Vec3 carried(const PairLaws& laws, const Encounter& meet, const Vec3& spring) const {
    if (meet.with_wall()) return laws.spring.turned(spring, meet.normal);
    return in_plane(spring, meet.normal) + carried_round(this->bodies_, meet, spring, now_.step);
  }

  Vec3 friction_over_step(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                          const ContactPoint& point, const Vec3& slip, double normal,
                          const ShearResponse& shear, ContactSprings& springs) {
    const Vec3 held = carried(laws, meet, springs.displacement), moved = moved_in(meet, arms);
    const Vec3 stretched = held + moved;
    springs.displacement = stretched;
    const Vec3 friction =
        laws.spring.force_over_step(springs.displacement, moved, slip, normal, shear, now_.step);
    if (springs.displacement != stretched && bends(laws))
      add_bend(laws, meet, arms, point, held, stretched, shear, normal);
    return friction;
  }

  Vec3 last(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms, ContactPoint point,
            ContactSprings springs) {
    const double root_mass = std::sqrt(point.effective_mass);
    ContactResponse now = response(laws, point, root_mass);
    const double damping = now.damping;
    if constexpr (corrects) {
      refine(stiffness_now(laws, point, now), inverse_mass(meet), now);
      if (laws.spring.present()) refine_shear(meet, arms, now);
    }
    Crossing crossing{.elapsed = this->history_.elapsed(), .passed = !now_.started};
    if constexpr (corrects)
      if (now_.started && may_let_go(laws, meet, point, now)) {
        crossing = pass_zero(laws, meet, arms, point, springs);
        springs = crossing.springs;
        if (crossing.followed) follow(laws, crossing, point, now);
      }
    const double elapsed = crossing.elapsed;
    const auto of_spring = [&](const Vec3& slip, double normal) -> Vec3 {
      if constexpr (corrects)
        if (!crossing.passed) {
          keep_force(laws, point, springs);
          return friction_over_step(laws, meet, arms, point, slip, normal, now.shear, springs);
        }
      const Vec3 moved = crossing.passed ? (slip * elapsed).eval() : moved_in(meet, arms);
      return spring_friction(laws, point, slip, normal, now.shear, moved, springs);
    };
    const ContactForce force = contact_force(laws, point, now, damping, root_mass, of_spring);
    if constexpr (corrects)
      if (crossing.followed) add_turnover(meet, arms, crossing, force.friction);
    if constexpr (turning) {
      this->twist(meet, arms, meet.normal.cross(force.friction));
      if (laws.rolling.present())
        this->resist_rolling(laws, meet, winding_spin(laws, meet, arms), point, force.normal, elapsed,
                             springs);
    }
    this->log_.contact(laws, meet, arms, point, force, springs);
    keep(laws, meet, springs);
    return force.normal * meet.normal + force.friction;
  }

  /// Whether the normal force can have changed its sign within the step.
  bool may_let_go(double stiffness, double rate, double inverse_mass, const ContactResponse& now) const {
    const double force = now.push + now.damping * rate;
    const double change =
        now_.step * (2.0 * stiffness * std::abs(rate) + now.damping * std::abs(force) * inverse_mass);
    return std::abs(force) < 2.0 * change;
  }

  /// Where that matters.
  bool may_let_go(const PairLaws& laws, const Encounter& meet, const ContactPoint& point,
                  const ContactResponse& now) const {
    if (!laws.spring.present() && !laws.normal.no_tension) return false;
    const double rate = -point.relative_velocity.dot(point.normal);
    return may_let_go(stiffness_now(laws, point, now), rate, inverse_mass(meet), now);
  }

  /// Where the normal force passes zero a spring is cut back to nothing, and a contact that cannot pull has
  /// acted for a part of the step. Rare, and given copies as begin() is.
  struct Crossing {
    double elapsed;  ///< for which the spring is stretched since, s
    ContactSprings springs = {};
    bool passed = true;        ///< else it has lasted through the step
    bool followed = false;     ///< friction too; then
    Vec3 slip = Vec3::Zero();  ///< at the boundary, and
    Vec3 rub = Vec3::Zero();   ///< what friction did until zero, less the plain scheme's in half a step, N s
  };
  [[gnu::noinline]] Crossing pass_zero(const PairLaws& laws, Encounter meet, TorqueArms arms,
                                       ContactPoint point, ContactSprings springs);

  static double stiffness_now(const PairLaws& laws, const ContactPoint& point, const ContactResponse& now) {
    return laws.hertz.present() ? 1.5 * now.push / point.overlap : laws.normal.stiffness;
  }

  void refine(double stiffness, double inverse_mass, ContactResponse& now) const {
    now.damping *= refined_share(stiffness, now.damping, inverse_mass, now_.foresight());
  }

  void refine_shear(const Encounter& meet, const TorqueArms& arms, ContactResponse& now) const {
    now.shear.damping *= refined_share(now.shear.stiffness, now.shear.damping,
                                       inverse_sliding_mass(meet, arms), now_.foresight());
  }

  Vec3 moved_in(const Encounter& meet, const TorqueArms& arms) const {
    return moved_in_step<turning>(this->bodies_, meet, arms, now_.step);
  }

  double inverse_mass(const Encounter& meet) const {
    const double of_second = this->bodies_.body[meet.second].inverse_mass;
    return meet.with_wall() ? of_second : of_second + this->bodies_.body[meet.first].inverse_mass;
  }

  /// The inverse of what resists a change of the slip, 1/kg: the bodies' turning helps it along.
  double inverse_sliding_mass(const Encounter& meet, const TorqueArms& arms) const {
    double inverse = inverse_mass(meet);
    if constexpr (turning) {
      inverse += arms.second * arms.second * this->bodies_.spin[meet.second].inverse_inertia;
      if (!meet.with_wall())
        inverse += arms.first * arms.first * this->bodies_.spin[meet.first].inverse_inertia;
    }
    return inverse;
  }

  static Vec3 in_plane(const Vec3& velocity, const Vec3& normal) {
    return velocity - velocity.dot(normal) * normal;
  }

  static Vec3 slip_at(const ContactPoint& point) { return in_plane(point.relative_velocity, point.normal); }

  void keep(const PairLaws& laws, const Encounter& meet, const ContactSprings& springs) {
    if (corrects || laws.remembers()) memory_.keep(this->memory_key(meet), meet.second, springs);
  }

  /// What turns a rolling spring is the turn itself; a constant torque is against the predicted spin.
  Vec3 winding_spin(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms) const {
    if (!laws.rolling.spring || !now_.started) return this->rolling_spin(laws, meet, arms);
    const Bodies& bodies = this->bodies_;
    const Vec3& of_first = meet.with_wall() ? this->walls_[wall_of(meet)].spin : bodies.half_spin[meet.first];
    return this->as_rolling(laws, meet, arms, bodies.half_spin[meet.second] - of_first);
  }

  static Vec3 spring_at_touch(const PairLaws& laws, const ContactPoint& point, const Vec3& slip, double rate);

  /// Rare, and kept out of the loops that are flattened. Given copies, since what it could see through a
  /// reference every contact would have to hold in memory.
  [[gnu::noinline]] Vec3 begin(const PairLaws& laws, Encounter meet, TorqueArms arms, ContactPoint point);

  /// Friction bends where the limit takes hold of it within a step. Told of by laws whose dashpot bends with
  /// the spring.
  static bool bends(const PairLaws& laws) {
    return laws.spring.present() && !laws.hertz.present() &&
           laws.spring.limit == CoulombLimit::spring_and_dashpot;
  }
  Grip grip_before(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                   const ContactPoint& point, const BeforeParting& before, const Vec3& held) const;
  [[gnu::noinline]] void add_bend(const PairLaws& laws, Encounter meet, TorqueArms arms, ContactPoint point,
                                  Vec3 held, Vec3 stretched, ShearResponse shear, double normal);
  void add_turnover(const Encounter& meet, const TorqueArms& arms, const Crossing& crossing,
                    const Vec3& friction);
  static void follow(const PairLaws& laws, const Crossing& crossing, ContactPoint& point,
                     ContactResponse& now);
  Crossing follow_through_zero(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                               const ContactPoint& point, const BeforeParting& before, double last,
                               ContactSprings springs) const;
  Vec3 rub_to_the_end(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                      const BeforeParting& before, const Vec3& spring, double lasted) const;

  void add_ending(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                  const BeforeParting& before, ContactSprings springs);
  BeforeParting before_parting(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                               double effective_mass) const;
  Vec3 resist_to_the_end(const PairLaws& laws, const ContactPoint& point, const Vec3& rolling,
                         const ContactForce& force, const PartialPush& push, ContactSprings springs) const;

  Memory& memory_;
  const BoundaryStep now_;
  OnsetEvents& events_;
};

}  // namespace grainproof::reference
