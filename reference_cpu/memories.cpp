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

ContactMemory by_id(const Scene& scene, const ContactHistory::Memory& memory, const Bodies& bodies) {
  const auto id = [&](std::int32_t body) { return scene.particles[bodies.origin[body]].id; };
  const auto& [displacement, torque, overlap] = memory.springs;
  const auto particles = static_cast<std::int32_t>(bodies.size());
  if (memory.first >= particles)
    return {id(memory.second), particles - 1 - memory.first, 0, displacement, overlap, torque};
  if (id(memory.first) < id(memory.second))
    return {id(memory.first), id(memory.second), 0, displacement, overlap, Vec3::Zero() - torque};
  return {id(memory.second), id(memory.first), 0, Vec3::Zero() - displacement, overlap, torque};
}

/// Pairs by rising ids; after them wall by wall, by rising ids.
bool precedes(const ContactMemory& a, const ContactMemory& b) {
  const auto key = [](const ContactMemory& memory) {
    return memory.second < 0 ? std::tuple(true, -memory.second, memory.first)
                             : std::tuple(false, memory.first, memory.second);
  };
  return key(a) < key(b);
}

}  // namespace

std::vector<ContactHistory::Memory> memories_of(const Scene& scene) {
  std::vector<ContactHistory::Memory> memories;
  for (const ContactMemory& memory : scene.remembered) memories.push_back(by_index(scene, memory));
  std::ranges::sort(memories, {}, [](const auto& memory) { return std::tuple(memory.first, memory.second); });
  return memories;
}

std::vector<ContactMemory> memories_by_id(const Scene& scene, const ContactHistory& history,
                                          const Bodies& bodies) {
  std::vector<ContactMemory> memories;
  for (const ContactHistory::Memory& memory : history.memories())
    memories.push_back(by_id(scene, memory, bodies));
  std::ranges::sort(memories, precedes);
  return memories;
}

void pack_memories(Sections& own, const ContactHistory& history) {
  pack(own, "memories", history.memories());
}

std::vector<ContactHistory::Memory> unpacked_memories(const Sections& own) {
  std::vector<ContactHistory::Memory> memories;
  unpack(own, "memories", memories);
  return memories;
}

}  // namespace grainproof::reference
