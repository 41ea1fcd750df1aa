// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/force_log.hpp"

#include <algorithm>

namespace grainproof::reference {

void ForceLog::clear() {
  elastic = tangential = cohesive = 0.0;
  support = Vec3::Zero();
  std::ranges::fill(wall_force_on_particles, Vec3::Zero());
  contacts.clear();
}

// A clamped normal force counts as spring and a dashpot that cancels it: the two add up to what acts.
void ForceLog::contact(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms,
                       const ContactPoint& point, const ContactForce& force, const Vec3& displacement) {
  const Stored stored = stored_in(laws, point, displacement);
  elastic += stored.normal_energy;
  tangential += stored.tangential_energy;
  contacts.push_back({meet, arms, (force.normal - stored.push) * point.normal, force.friction});
}

void ForceLog::attraction(const PairLaws& laws, double effect_overlap) {
  cohesive += laws.cohesion.potential(effect_overlap);
}

void ForceLog::pair_force(const Bodies& bodies, std::int32_t first, std::int32_t second,
                          const Vec3& on_second) {
  if (bodies.body[first].fixed()) support += on_second;
  if (bodies.body[second].fixed()) support -= on_second;
}

void ForceLog::wall_force(std::size_t wall, const Vec3& on_particle) {
  support += on_particle;
  wall_force_on_particles[wall] += on_particle;
}

}  // namespace grainproof::reference
