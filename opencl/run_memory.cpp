// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <tuple>

#include "opencl/run.hpp"

namespace grainproof::opencl {
namespace {

const ContactLaws& laws_of(const Scene& scene, std::int32_t a, std::int32_t b) {
  return scene.contacts.at(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
}

/// Others may remember that they are there, which is no news.
bool keeps_spring(const ContactLaws& laws) {
  return std::holds_alternative<HistoryFriction>(laws.friction);
}

bool keeps_overlap(const ContactLaws& laws) {
  const auto* history = std::get_if<HistoryFriction>(&laws.friction);
  return history != nullptr && history->memory == SpringMemory::force;
}

}  // namespace

std::vector<ContactMemory> DeviceRun::memories() {
  if (!options_.history) return {};
  std::vector<ContactMemory> found = pair_memories();
  append_wall_memories(found);
  std::sort(found.begin(), found.end(), [](const ContactMemory& a, const ContactMemory& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return found;
}

// As the particle that the slot belongs to has it.
ContactMemory DeviceRun::memory_at(std::span<const std::byte> memories, std::size_t slot,
                                   const ContactLaws& laws) const {
  const std::size_t words = options_.memory_words();
  ContactMemory memory{};
  memory.tangential_displacement = decoder_->vector(memories, words * slot);
  if (keeps_overlap(laws)) memory.overlap = decoder_->fourth(memories, words * slot);
  if (options_.rolling_spring) memory.rolling_torque = decoder_->vector(memories, words * slot + 1);
  return memory;
}

// A device keeps the displacement of the particle that a row belongs to relative to its partner, and the
// torque on it; told are the displacement of the second relative to the first and the torque on the first.
void DeviceRun::append_memory(std::vector<ContactMemory>& found, std::size_t i, std::size_t j,
                              std::span<const std::byte> memories, std::size_t slot) const {
  const Particle &self = scene_.particles[i], &other = scene_.particles[j];
  const std::size_t words = options_.memory_words();
  if (decoder_->fourth(memories, words * slot) == 0.0 || (i > j && !other.fixed)) return;
  if (!keeps_spring(laws_of(scene_, self.material, other.material))) return;
  ContactMemory memory = memory_at(memories, slot, laws_of(scene_, self.material, other.material));
  (i < j ? memory.tangential_displacement : memory.rolling_torque) *= -1.0;
  memory.first = i < j ? self.id : other.id;
  memory.second = i < j ? other.id : self.id;
  found.push_back(memory);
}

// Displacement and torque of the particle relative to the wall.
void DeviceRun::append_wall_memories(std::vector<ContactMemory>& found) {
  const std::size_t walls = image_.near.count(), words = options_.memory_words();
  const Bytes memories = read_particles(world_.wall_springs, walls * memory_bytes(options_, *decoder_));
  for (std::size_t i = 0; i < image_.particles; ++i) {
    std::size_t slot = i * walls;
    image_.near.each([&](const auto& wall) {
      const std::size_t here = slot++;
      if (decoder_->fourth(memories, words * here) == 0.0) return;
      const Particle& self = scene_.particles[i];
      if (!keeps_spring(laws_of(scene_, self.material, wall.material))) return;
      ContactMemory memory = memory_at(memories, here, laws_of(scene_, self.material, wall.material));
      memory.first = self.id;
      memory.second = -1 - wall.index;
      found.push_back(memory);
    });
  }
}

std::size_t DeviceRun::index_of(std::int64_t id) const {
  const auto found = std::ranges::lower_bound(scene_.particles, id, {}, &Particle::id);
  return static_cast<std::size_t>(found - scene_.particles.begin());
}

// The fourth number marks a contact that is known, so that it is forgotten where the bodies turn out to be
// apart; where no overlap is told, it is one that no law asks for, longer than any.
void DeviceRun::put_memory(Bytes& memories, std::size_t slot, const ContactMemory& memory,
                           double sign) const {
  const std::size_t words = options_.memory_words();
  decoder_->put(memories, words * slot, sign * memory.tangential_displacement,
                memory.overlap > 0.0 ? memory.overlap : 1.0);
  if (options_.rolling_spring)
    decoder_->put(memories, words * slot + 1, sign * Vec3(-memory.rolling_torque), 0.0);
}

Bytes DeviceRun::remembered_pairs(
    std::size_t slots,
    const std::function<std::optional<std::size_t>(std::size_t, std::size_t)>& slot_of) const {
  Bytes memories(slots * memory_bytes(options_, *decoder_));
  for (const ContactMemory& memory : scene_.remembered) {
    if (memory.second < 0) continue;
    const std::size_t first = index_of(memory.first), second = index_of(memory.second);
    if (const auto slot = slot_of(second, first)) put_memory(memories, *slot, memory, 1.0);
    if (const auto slot = slot_of(first, second)) put_memory(memories, *slot, memory, -1.0);
  }
  return memories;
}

void DeviceRun::remember_walls() {
  if (scene_.remembered.empty()) return;
  const std::size_t walls = image_.near.count();
  Bytes memories(std::max<std::size_t>(image_.padded * walls, 1) * memory_bytes(options_, *decoder_));
  for (ContactMemory memory : scene_.remembered) {
    if (memory.second >= 0) continue;
    std::size_t slot = index_of(memory.first) * walls;
    memory.rolling_torque *= -1.0;
    image_.near.each([&](const auto& wall) {
      if (-1 - wall.index == memory.second) put_memory(memories, slot, memory, 1.0);
      ++slot;
    });
  }
  workshop_->write(world_.wall_springs, memories);
}

}  // namespace grainproof::opencl
