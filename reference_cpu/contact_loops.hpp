// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "reference_cpu/contacts.hpp"
#include "reference_cpu/encounter.hpp"
#include "reference_cpu/surfaces.hpp"

/// Who meets whom: the loops over listed pairs and walls. What they do to each other is up to Touch.
namespace grainproof::reference {

// Flattened: what a contact is told and tells would otherwise go through memory, a quarter of the time of a
// step with history.
template <bool periodic, class Touch, class Log>
[[gnu::flatten]] void add_pair_forces(const ContactSetting& setting, const PairList& pairs, Bodies& bodies,
                                      Watch& watch, Touch touch, Log& log) {
  const auto count = static_cast<std::int32_t>(bodies.size());
  for (std::int32_t i = 0; i < count; ++i) {
    const Body& one = bodies.body[i];
    Vec3 on_one = bodies.acceleration[i];
    for (std::int32_t pair = pairs.first(i); pair < pairs.last(i); ++pair) {
      const std::int32_t j = pairs.partner(pair);
      const Body& two = bodies.body[j];
      Vec3 apart = two.position - one.position;
      if constexpr (periodic) apart = setting.box.nearest_image(apart);
      const double touching = one.radius + two.radius;
      const double range = Touch::cohesive ? bodies.reach[i] + bodies.reach[j] : touching;
      const double square = apart.squaredNorm();
      if (square >= range * range) continue;
      const double distance = std::sqrt(square);
      const Encounter meet{i, j, apart * (1.0 / distance), touching - distance, range - distance};
      if (meet.overlap > watch.overlap_limit() * std::min(one.radius, two.radius)) [[unlikely]]
        watch.report({Trouble::Kind::pair_too_deep, i, j, meet.overlap});
      const double effective_mass = 1.0 / (one.inverse_mass + two.inverse_mass);
      const PairLaws& laws = setting.laws.at(bodies.material[i], bodies.material[j]);
      const Vec3 force = touch.force_on_second(laws, meet, two.velocity - one.velocity, effective_mass);
      log.pair_force(bodies, i, j, force);
      on_one -= force;
      bodies.acceleration[j] += force;
    }
    bodies.acceleration[i] = on_one;
  }
}

template <class Shape, class Touch, class Log>
void add_wall_force(const ContactSetting& setting, const Shape& shape, std::size_t wall, std::int32_t i,
                    Bodies& bodies, Watch& watch, Touch& touch, Log& log) {
  const Body& body = bodies.body[i];
  const auto [normal, distance] = nearest(shape, body.position, setting.box);
  const double range = Touch::cohesive ? bodies.reach[i] : body.radius;
  if (distance >= range) return;
  const WallNow& stands = setting.walls[wall];
  const Vec3 surface = body.position - distance * normal;
  Encounter meet{wall_as_body(wall), i, normal, body.radius - distance, range - distance};
  if (stands.moving) meet.wall_velocity = stands.velocity_at(surface);
  if (meet.overlap > watch.overlap_limit() * body.radius) [[unlikely]]
    watch.report({Trouble::Kind::wall_too_deep, i, static_cast<std::int32_t>(wall), meet.overlap});
  const PairLaws& laws = setting.laws.at(stands.material, bodies.material[i]);
  const Vec3 force =
      touch.force_on_second(laws, meet, body.velocity - meet.wall_velocity, 1.0 / body.inverse_mass);
  log.wall_force(meet, force, arm_to(shape, surface, setting.box));
  bodies.acceleration[i] += force;
}

template <class Touch, class Log>
void add_wall_forces(const ContactSetting& setting, const NearWalls& near, Bodies& bodies, Watch& watch,
                     Touch touch, Log& log) {
  for (std::size_t wall = 0; wall < setting.walls.size(); ++wall)
    std::visit(
        [&](const auto& shape) {
          for (const std::int32_t i : near.near(wall))
            add_wall_force(setting, shape, wall, i, bodies, watch, touch, log);
        },
        setting.walls[wall].shape);
}

/// Pairs first, then walls. Torques, where there are any, are the business of Touch.
template <class Touch, class Log>
void add_forces_by(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies, Watch& watch,
                   const Touch& touch, Log& log) {
  if (setting.box.any())
    add_pair_forces<true>(setting, neighbours.pairs(), bodies, watch, touch, log);
  else
    add_pair_forces<false>(setting, neighbours.pairs(), bodies, watch, touch, log);
  add_wall_forces(setting, neighbours.walls(), bodies, watch, touch, log);
}

}  // namespace grainproof::reference
