// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/onset/partial_contact.hpp"

namespace grainproof::reference {

ContactResponse PartialContact::response_at(const NormalState& state) const {
  ContactPoint point = point_;
  point.overlap = state.overlap;
  return response(laws_, point, root_mass_);
}

double PartialContact::force_at(const NormalState& state) const {
  const ContactResponse now = response_at(state);
  return now.push + now.damping * state.rate;
}

DampedFlow PartialContact::flow() const {
  return {laws_.normal.stiffness, laws_.normal.damping_for(root_mass_), point_.effective_mass};
}

// Bodies that part while they first overlap have been together for no time that could be told: a whole step.
Beginning PartialContact::beginning(const NormalState& reached) const {
  const double lasted = reached.rate > 0.0 ? std::min(reached.overlap / reached.rate, step_) : step_;
  if (hertz()) return hertz_beginning(reached, lasted);
  const double mass = point_.effective_mass, arrival = reached.overlap / lasted;
  const NormalState end = flow().after({0.0, arrival}, lasted);
  double impulse = mass * (arrival - end.rate);
  if (laws_.normal.no_tension) impulse = std::max(impulse, 0.0);
  return {end, {lasted, impulse, mass * (reached.overlap - end.overlap), std::abs(impulse) / lasted}};
}

// The force moves as the overlap does, so a contact that cannot pull lets go where its force would part.
double PartialContact::time_left(const NormalState& left) const {
  const DampedFlow motion = flow();
  const double until_apart = motion.time_to_part(left);
  if (!laws_.normal.no_tension) return std::min(until_apart, step_);
  const double force = force_at(left);
  const double change = laws_.normal.stiffness * left.rate -
                        laws_.normal.damping_for(root_mass_) * force / point_.effective_mass;
  return std::min({until_apart, motion.time_to_part({force, change}), step_});
}

/// Simpson's rule.
double PartialContact::mean_magnitude(const NormalState& left, double time) const {
  const DampedFlow motion = flow();
  const auto magnitude = [&](double after) { return std::abs(force_at(motion.after(left, after))); };
  return (magnitude(0.0) + 4.0 * magnitude(0.5 * time) + magnitude(time)) / 6.0;
}

PartialPush PartialContact::ending(const NormalState& left) const {
  if (hertz()) return hertz_ending(left);
  const double mass = point_.effective_mass, lasted = time_left(left);
  const NormalState end = flow().after(left, lasted);
  const double impulse = mass * (left.rate - end.rate);
  const double moved = mass * (left.overlap + left.rate * lasted - end.overlap);
  return {lasted, impulse, moved + (step_ - lasted) * impulse, mean_magnitude(left, lasted)};
}

Vec3 friction_impulse(const PairLaws& laws, const ContactPoint& point, const Vec3& slip, const Vec3& spring,
                      const PartialPush& push, const ShearShare& share) {
  const double root_mass = std::sqrt(point.effective_mass);
  const ContactResponse now = response(laws, point, root_mass);
  if (laws.spring.present()) {
    const ShearResponse shear{share.stiffness * now.shear.stiffness, share.damping * now.shear.damping};
    Vec3 half_way = spring + slip * (0.5 * push.lasted);
    return laws.spring.force(half_way, slip, push.mean_magnitude, shear) * push.lasted;
  }
  if (laws.friction.coefficient == 0.0) return Vec3::Zero();
  return laws.friction.force(slip, push.mean_magnitude, now.damping, root_mass) * push.lasted;
}

Vec3 limited_impulse(const Vec3& first, const Vec3& last, double most_first, double most_last, double time) {
  const double size = first.norm(), length = last.norm();
  const Vec3 held = size > most_first ? (first * (most_first / size)).eval() : first;
  Vec3 impulse = -0.5 * time * (held + last);
  const double excess = length - most_last;
  if (excess <= 0.0) return impulse;
  const Vec3 along = last / length;
  const double room = std::max(most_first - held.dot(along), 0.0);
  return impulse + along * (0.5 * time * excess * excess / (room + excess));
}

}  // namespace grainproof::reference
