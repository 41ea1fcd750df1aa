// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/ledger_keeper.hpp"

#include <Eigen/Geometry>

namespace grainproof::reference {
namespace {

double kinetic_energy(const Bodies& bodies, const Motion& motion) {
  double sum = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (!bodies.body[i].fixed()) sum += 0.5 * bodies.mass[i] * motion.velocity[i].squaredNorm();
  for (std::size_t i = 0; i < bodies.spin.size(); ++i)
    if (!bodies.body[i].fixed())
      sum += 0.5 / bodies.spin[i].inverse_inertia * motion.angular_velocity[i].squaredNorm();
  return sum;
}

}  // namespace

void LedgerKeeper::begin() {
  sums_.taken_by_friction.add(log_.tangential);
  sums_.taken_by_rolling.add(log_.wound);
}

void LedgerKeeper::before_kick(const Bodies& bodies) {
  before_ = motion_after(bodies, 0.0);
}

void LedgerKeeper::after_kick(const Bodies& bodies, double duration) {
  book(sums_, {bodies, before_, motion_after(bodies, 0.0), duration});
}

Ledger LedgerKeeper::at(const Bodies& bodies, double pending) const {
  Sums sums = sums_;
  const Motion synchronised = motion_after(bodies, pending);
  book(sums, {bodies, motion_after(bodies, 0.0), synchronised, pending});
  Ledger ledger;
  ledger.kinetic = kinetic_energy(bodies, synchronised);
  ledger.elastic = log_.elastic + log_.tangential + log_.wound;
  ledger.cohesive = log_.cohesive;
  ledger.gravity_work = sums.gravity_work.value();
  ledger.drag_work = sums.drag_work.value();
  ledger.wall_work = sums.wall_work.value();
  ledger.dissipated_normal = sums.dissipated_normal.value();
  ledger.dissipated_tangential = sums.taken_by_friction.value() - log_.tangential;
  ledger.dissipated_rolling = sums.taken_by_rolling.value() - log_.wound;
  ledger.support_impulse = sums.support.value();
  ledger.field_impulse = sums.field.value();
  for (const WallSums& wall : sums.walls) {
    ledger.wall_impulses.push_back(wall.impulse.value());
    ledger.wall_angular_impulses.push_back(wall.angular_impulse.value());
  }
  return ledger;
}

void LedgerKeeper::pack_into(Sections& own) const {
  log_.pack_into(own);
  pack_one(own, "ledger.totals", static_cast<const Totals&>(sums_));
  pack(own, "ledger.walls", sums_.walls);
}

void LedgerKeeper::unpack_from(const Sections& own) {
  log_.unpack_from(own);
  unpack_one(own, "ledger.totals", static_cast<Totals&>(sums_));
  unpack(own, "ledger.walls", sums_.walls);
}

void LedgerKeeper::book(Sums& sums, const Kick& kick) const {
  sums.support.add(log_.support * kick.duration);
  sums.wall_work.add(log_.wall_power * kick.duration);
  for (std::size_t wall = 0; wall < sums.walls.size(); ++wall) {
    sums.walls[wall].impulse.add(log_.walls[wall].force * kick.duration);
    sums.walls[wall].angular_impulse.add(log_.walls[wall].moment * kick.duration);
  }
  book_contacts(sums, kick);
  book_rolling(sums, kick);
  book_fields(sums, kick);
}

void LedgerKeeper::book_contacts(Sums& sums, const Kick& kick) const {
  for (const LoggedContact& contact : log_.contacts) {
    Vec3 path = kick.path(contact.meet.second) - contact.meet.wall_velocity * kick.duration;
    if (!contact.meet.with_wall()) path -= kick.path(contact.meet.first);
    sums.dissipated_normal.add(-contact.dashpot.dot(path));
    if (kick.bodies.turning()) path -= sweep(kick, contact).cross(contact.meet.normal);
    sums.taken_by_friction.add(-contact.friction.dot(path));
  }
}

void LedgerKeeper::book_rolling(Sums& sums, const Kick& kick) const {
  for (const LoggedRolling& rolling : log_.rollings) {
    Vec3 turn = kick.turn(rolling.meet.second) - rolling.wall_spin * kick.duration;
    if (!rolling.meet.with_wall()) turn -= kick.turn(rolling.meet.first);
    sums.taken_by_rolling.add(-rolling.torque.dot(turn));
  }
}

Vec3 LedgerKeeper::sweep(const Kick& kick, const LoggedContact& contact) {
  Vec3 sum = contact.arms.second * kick.turn(contact.meet.second);
  if (!contact.meet.with_wall()) sum += contact.arms.first * kick.turn(contact.meet.first);
  return sum;
}

void LedgerKeeper::book_fields(Sums& sums, const Kick& kick) const {
  const bool drag = !kick.bodies.drag_rate.empty();
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(kick.bodies.size()); ++i) {
    if (kick.bodies.body[i].fixed()) continue;
    sums.gravity_work.add(log_.gravity[i].dot(kick.path(i)));
    sums.field.add(log_.gravity[i] * kick.duration);
    if (!drag) continue;
    const Vec3 impulse = drag_impulse(kick, i);
    sums.drag_work.add(impulse.dot(0.5 * (kick.before.velocity[i] + kick.after.velocity[i])));
    sums.field.add(impulse);
  }
}

// Where the integrator applies drag it takes the velocity at the end of the step.
Vec3 LedgerKeeper::drag_impulse(const Kick& kick, std::int32_t particle) const {
  if (log_.fluid.empty()) return log_.drag[particle] * kick.duration;
  const double steps_per_response = kick.duration * kick.bodies.drag_rate[particle];
  return kick.bodies.mass[particle] * steps_per_response *
         (log_.fluid[particle] - kick.after.velocity[particle]);
}

}  // namespace grainproof::reference
