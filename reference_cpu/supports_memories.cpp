// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "reference_cpu/laws/pair_laws.hpp"
#include "reference_cpu/supports.hpp"
#include "reference_cpu/surfaces.hpp"
#include "reference_cpu/walls.hpp"

namespace grainproof::reference {
namespace {

const Particle* particle_with(const Scene& scene, std::int64_t id) {
  const auto found = std::ranges::lower_bound(scene.particles, id, {}, &Particle::id);
  return found == scene.particles.end() || found->id != id ? nullptr : &*found;
}

/// Who a memory is about.
struct Partners {
  const Particle* first = nullptr;
  const Particle* second = nullptr;  ///< null for a wall
  const Wall* wall = nullptr;        ///< null for a particle

  bool known() const { return first && (second || wall); }
  std::int32_t material_of_second() const { return wall ? wall->material : second->material; }
};

Partners partners(const Scene& scene, const ContactMemory& memory) {
  Partners named{.first = particle_with(scene, memory.first)};
  const std::int64_t wall = -1 - memory.second;
  if (memory.second >= 0)
    named.second = memory.second > memory.first ? particle_with(scene, memory.second) : nullptr;
  else if (wall < static_cast<std::int64_t>(scene.walls.size()))
    named.wall = &scene.walls[wall];
  return named;
}

double overlap(const Scene& scene, const Partners& named) {
  const PeriodicBox box(scene.domain);
  const Vec3 position = box.inside(named.first->position);
  const double radius = 0.5 * named.first->diameter;
  if (named.second) {
    const Vec3 apart = box.nearest_image(box.inside(named.second->position) - position);
    return radius + 0.5 * named.second->diameter - apart.norm();
  }
  return std::visit([&](const auto& shape) { return radius - nearest(shape, position, box).distance; },
                    named.wall->shape);
}

bool kept_by(const PairLaws& laws, const ContactMemory& memory) {
  return memory.feature == 0 && (laws.spring.present() || memory.tangential_displacement == Vec3::Zero()) &&
         (laws.rolling.spring || memory.rolling_torque == Vec3::Zero()) &&
         (laws.spring.keeps_force || memory.overlap == 0.0);
}

Support memory_supported(const Scene& scene, const ContactMemory& memory) {
  const std::string who =
      "the contact of " + std::to_string(memory.first) + " and " + std::to_string(memory.second);
  const Partners named = partners(scene, memory);
  if (!named.known()) return Support::no(who + " is remembered, but not both of them are there");
  if (named.first->fixed && (named.wall || named.second->fixed))
    return Support::no(who + " is remembered, but neither of them moves");
  if (!(overlap(scene, named) > 0.0)) return Support::no(who + " is remembered, but they do not touch");
  if (!kept_by(resolve(scene, named.first->material, named.material_of_second()), memory))
    return Support::no(who + " remembers what none of its laws keeps");
  return {};
}

bool same_contact(const ContactMemory& one, const ContactMemory& two) {
  return one.first == two.first && one.second == two.second;
}

}  // namespace

Support memories_supported(const Scene& scene) {
  for (const ContactMemory& memory : scene.remembered)
    if (const Support support = memory_supported(scene, memory); !support) return support;
  if (std::ranges::adjacent_find(scene.remembered, same_contact) != scene.remembered.end())
    return Support::no("a contact is remembered twice");
  return {};
}

}  // namespace grainproof::reference
