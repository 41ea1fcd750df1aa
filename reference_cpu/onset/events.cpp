// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/onset/events.hpp"

#include <Eigen/Geometry>

namespace grainproof::reference {
namespace {

void move(Bodies& bodies, const PeriodicBox& box, std::int32_t i, const Vec3& impulse, const Vec3& shift) {
  Body& body = bodies.body[i];
  body.velocity += impulse * body.inverse_mass;
  body.position += shift * body.inverse_mass;
  if (box.any()) body.position = box.inside(body.position);
}

void turn(Bodies& bodies, std::int32_t i, const Vec3& angular_impulse) {
  bodies.spin[i].angular_velocity += angular_impulse * bodies.spin[i].inverse_inertia;
}

}  // namespace

// Friction turns both bodies alike, rolling resistance one against the other.
void correct(Bodies& bodies, const PeriodicBox& box, const OnsetEvent& event) {
  const Encounter& meet = event.meet;
  const Vec3 impulse = event.push + event.rub;
  move(bodies, box, meet.second, impulse, event.shift);
  if (!meet.with_wall()) move(bodies, box, meet.first, -impulse, -event.shift);
  if (!bodies.turning()) return;
  const Vec3 moment = meet.normal.cross(event.rub);
  turn(bodies, meet.second, event.resist - event.arms.second * moment);
  if (!meet.with_wall()) turn(bodies, meet.first, -event.resist - event.arms.first * moment);
}

}  // namespace grainproof::reference
