// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <tuple>

#include "opencl/near_walls.hpp"
#include "opencl/run.hpp"

namespace grainproof::opencl {

std::vector<ContactMemory> DeviceRun::memories() {
  if (!options_.history) return {};
  std::vector<ContactMemory> found = pair_memories();
  append_wall_memories(found);
  std::sort(found.begin(), found.end(), [](const ContactMemory& a, const ContactMemory& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return found;
}

// A device keeps the displacement of the particle that a row belongs to relative to its partner; told is that
// of the second relative to the first.
void DeviceRun::append_memory(std::vector<ContactMemory>& found, std::size_t i, std::size_t j,
                              std::span<const std::byte> springs, std::size_t slot) const {
  const Particle &self = scene_.particles[i], &other = scene_.particles[j];
  if (decoder_->fourth(springs, slot) == 0.0 || (i > j && !other.fixed)) return;
  const Vec3 displacement = decoder_->vector(springs, slot);
  if (i < j)
    found.push_back({self.id, other.id, 0, -displacement});
  else
    found.push_back({other.id, self.id, 0, displacement});
}

// Of the particle relative to the wall. Planes come first, as in kernels/history.cl.
void DeviceRun::append_wall_memories(std::vector<ContactMemory>& found) {
  const NearWalls near = near_walls(scene_);
  std::vector<std::int64_t> walls;
  for (const auto& wall : near.planes) walls.push_back(wall.index);
  for (const auto& wall : near.rectangles) walls.push_back(wall.index);
  const Bytes springs = read_particles(world_.wall_springs, walls.size() * decoder_->vector_bytes());
  for (std::size_t i = 0; i < image_.particles; ++i)
    for (std::size_t k = 0; k < walls.size(); ++k)
      if (const std::size_t slot = i * walls.size() + k; decoder_->fourth(springs, slot) != 0.0)
        found.push_back({scene_.particles[i].id, -1 - walls[k], 0, decoder_->vector(springs, slot)});
}

}  // namespace grainproof::opencl
