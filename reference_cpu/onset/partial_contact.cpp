// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/onset/partial_contact.hpp"

namespace grainproof::reference {
namespace {

DampedFlow flow_of(const PairLaws& laws, double mass) {
  return {laws.normal.stiffness, laws.normal.damping_for(std::sqrt(mass)), mass};
}

double force_at(const PairLaws& laws, const NormalState& state, double mass) {
  return laws.normal.force(state.overlap, -state.rate, laws.normal.damping_for(std::sqrt(mass)));
}

/// Simpson's rule for the magnitude of the force.
double mean_magnitude(const PairLaws& laws, const DampedFlow& flow, const NormalState& start, double time) {
  const auto magnitude = [&](double after) {
    return std::abs(force_at(laws, flow.after(start, after), flow.mass()));
  };
  return (magnitude(0.0) + 4.0 * magnitude(0.5 * time) + magnitude(time)) / 6.0;
}

}  // namespace

// Bodies that part while they first overlap have been together for no time that could be told: a whole step.
Beginning beginning(const PairLaws& laws, const NormalState& reached, double mass, double step) {
  const DampedFlow flow = flow_of(laws, mass);
  const double lasted = reached.rate > 0.0 ? std::min(reached.overlap / reached.rate, step) : step;
  const double arrival = reached.overlap / lasted;
  const NormalState end = flow.after({0.0, arrival}, lasted);
  double impulse = mass * (arrival - end.rate);
  if (laws.normal.no_tension) impulse = std::max(impulse, 0.0);
  return {end, {lasted, impulse, mass * (reached.overlap - end.overlap), std::abs(impulse) / lasted}};
}

PartialPush ending(const PairLaws& laws, const NormalState& left, double mass, double step) {
  if (laws.normal.no_tension && force_at(laws, left, mass) == 0.0) return {0.0, 0.0, 0.0, 0.0};
  const DampedFlow flow = flow_of(laws, mass);
  const double lasted = std::min(flow.time_to_part(left), step);
  const NormalState end = flow.after(left, lasted);
  const double impulse = mass * (left.rate - end.rate);
  const double moved = mass * (left.overlap + left.rate * lasted - end.overlap);
  return {lasted, impulse, moved + (step - lasted) * impulse, mean_magnitude(laws, flow, left, lasted)};
}

Vec3 friction_impulse(const PairLaws& laws, const ContactPoint& point, const Vec3& slip, const Vec3& spring,
                      const PartialPush& push) {
  const double root_mass = std::sqrt(point.effective_mass);
  const ContactResponse now = response(laws, point, root_mass);
  if (laws.spring.present()) {
    Vec3 half_way = spring + slip * (0.5 * push.lasted);
    return laws.spring.force(half_way, slip, push.mean_magnitude, now.shear) * push.lasted;
  }
  if (laws.friction.coefficient == 0.0) return Vec3::Zero();
  return laws.friction.force(slip, push.mean_magnitude, now.damping, root_mass) * push.lasted;
}

}  // namespace grainproof::reference
