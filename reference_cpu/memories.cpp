// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/memories.hpp"

#include <algorithm>
#include <tuple>

namespace grainproof::reference {
namespace {

std::int32_t index_of(const Scene& scene, std::int64_t id) {
  const auto found = std::ranges::lower_bound(scene.particles, id, {}, &Particle::id);
  return static_cast<std::int32_t>(found - scene.particles.begin());
}

// Torques are named as they act on the particle that is named first. Here body 2 of a pair is the second,
// and body 2 of a contact with a wall is the particle.
ContactHistory::Memory by_index(const Scene& scene, const ContactMemory& memory) {
  const std::int32_t first = index_of(scene, memory.first);
  const ContactSprings springs{memory.tangential_displacement, memory.rolling_torque, memory.overlap};
  if (memory.second < 0) {
    const auto wall = static_cast<std::int32_t>(-1 - memory.second);
    return {static_cast<std::int32_t>(scene.particles.size()) + wall, first, springs};
  }
  return {first,
          index_of(scene, memory.second),
          {springs.displacement, -springs.rolling_torque, springs.overlap}};
}

ContactMemory by_id(const ContactHistory::Memory& memory, const Bodies& bodies) {
  const std::int64_t second = bodies.id[memory.second];
  const auto& [displacement, torque, overlap] = memory.springs;
  const auto particles = static_cast<std::int32_t>(bodies.size());
  if (memory.first >= particles)
    return {second, particles - 1 - memory.first, 0, displacement, overlap, torque};
  return {bodies.id[memory.first], second, 0, displacement, overlap, Vec3::Zero() - torque};
}

}  // namespace

std::vector<ContactHistory::Memory> memories_of(const Scene& scene) {
  std::vector<ContactHistory::Memory> memories;
  for (const ContactMemory& memory : scene.remembered) memories.push_back(by_index(scene, memory));
  std::ranges::sort(memories, {}, [](const auto& memory) { return std::tuple(memory.first, memory.second); });
  return memories;
}

std::vector<ContactMemory> memories_by_id(const ContactHistory& history, const Bodies& bodies) {
  std::vector<ContactMemory> memories;
  for (const ContactHistory::Memory& memory : history.memories()) memories.push_back(by_id(memory, bodies));
  return memories;
}

}  // namespace grainproof::reference
