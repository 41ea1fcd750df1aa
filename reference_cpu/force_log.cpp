// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/force_log.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace grainproof::reference {

void ForceLog::clear() {
  elastic = tangential = wound = cohesive = wall_power = 0.0;
  support = Vec3::Zero();
  std::ranges::fill(walls, WallAction{});
  contacts.clear();
  rollings.clear();
}

// A clamped normal force counts as spring and a dashpot that cancels it: the two add up to what acts.
void ForceLog::contact(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                       const ContactPoint& point, const ContactForce& force, const ContactSprings& springs) {
  const Stored stored = stored_in(laws, point, springs);
  elastic += stored.normal_energy;
  tangential += stored.tangential_energy;
  wound += stored.rolling_energy;
  contacts.push_back({meet, arms, (force.normal - stored.push) * point.normal, force.friction});
}

void ForceLog::rolling(const Encounter& meet, const Vec3& on_second, const Vec3& spin_one) {
  const Vec3 wall_spin = meet.with_wall() ? spin_one : Vec3::Zero();
  rollings.push_back({meet, on_second, wall_spin});
  if (!meet.with_wall()) return;
  walls[wall_of(meet)].moment += on_second;
  wall_power += on_second.dot(wall_spin);
}

void ForceLog::attraction(const PairLaws& laws, double effect_overlap) {
  cohesive += laws.cohesion.potential(effect_overlap);
}

void ForceLog::pair_force(const Bodies& bodies, std::int32_t first, std::int32_t second,
                          const Vec3& on_second) {
  if (bodies.body[first].fixed()) support += on_second;
  if (bodies.body[second].fixed()) support -= on_second;
}

void ForceLog::wall_force(const Encounter& meet, const Vec3& on_particle, const Vec3& arm) {
  support += on_particle;
  walls[wall_of(meet)].force += on_particle;
  walls[wall_of(meet)].moment += arm.cross(on_particle);
  wall_power += on_particle.dot(meet.wall_velocity);
}

}  // namespace grainproof::reference
