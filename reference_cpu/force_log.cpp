// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/force_log.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

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

void ForceLog::pack_into(Sections& own) const {
  pack(own, "log.energies", std::vector{elastic, tangential, wound, cohesive, wall_power});
  pack_one(own, "log.support", support);
  pack(own, "log.walls", walls);
  pack(own, "log.contacts", contacts);
  pack(own, "log.rollings", rollings);
  pack(own, "log.gravity", gravity);
  pack(own, "log.drag", drag);
  pack(own, "log.fluid", fluid);
}

void ForceLog::unpack_from(const Sections& own) {
  std::vector<double> energies;
  unpack(own, "log.energies", energies);
  if (energies.size() != 5) throw InputRefused("the checkpoint's ledger has another number of energies");
  std::tie(elastic, tangential, wound, cohesive, wall_power) =
      std::tie(energies[0], energies[1], energies[2], energies[3], energies[4]);
  unpack_one(own, "log.support", support);
  unpack(own, "log.walls", walls);
  unpack(own, "log.contacts", contacts);
  unpack(own, "log.rollings", rollings);
  unpack(own, "log.gravity", gravity);
  unpack(own, "log.drag", drag);
  unpack(own, "log.fluid", fluid);
}

}  // namespace grainproof::reference
