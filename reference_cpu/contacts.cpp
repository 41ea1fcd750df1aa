// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/contacts.hpp"

#include <algorithm>
#include <type_traits>

#include "reference_cpu/surfaces.hpp"

namespace grainproof::reference {
namespace {

/// Two surfaces near each other, body 2 seen from body 1.
struct Encounter {
  std::int32_t first;  ///< particle, or no_particle for a wall
  std::int32_t second;
  Vec3 normal;
  double overlap;
  double effect_overlap;
};

template <bool cohesive, class Log>
Vec3 force_on_second(const PairLaws& laws, const Encounter& meet, const Vec3& relative_velocity,
                     double effective_mass, Log& log) {
  Vec3 force = Vec3::Zero();
  if (meet.overlap > 0.0) {
    const ContactPoint point{meet.normal, meet.overlap, relative_velocity, effective_mass};
    const ContactForce contact = contact_force(laws, point);
    force = contact.normal * meet.normal + contact.friction;
    log.contact(meet.first, meet.second, laws, point, contact);
  }
  if constexpr (cohesive) {
    if (laws.cohesion.stiffness > 0.0 && meet.effect_overlap > 0.0) {
      force += laws.cohesion.force(meet.effect_overlap) * meet.normal;
      log.attraction(laws, meet.effect_overlap);
    }
  }
  return force;
}

template <bool periodic, bool cohesive, class Log>
void add_pair_forces(const ContactSetting& setting, const PairList& pairs, Bodies& bodies, Watch& watch,
                     Log& log) {
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
      const double range = cohesive ? bodies.reach[i] + bodies.reach[j] : touching;
      const double square = apart.squaredNorm();
      if (square >= range * range) continue;
      const double distance = std::sqrt(square);
      const Encounter meet{i, j, apart * (1.0 / distance), touching - distance, range - distance};
      if (meet.overlap > watch.overlap_limit() * std::min(one.radius, two.radius)) [[unlikely]]
        watch.report({Trouble::Kind::pair_too_deep, i, j, meet.overlap});
      const double effective_mass = 1.0 / (one.inverse_mass + two.inverse_mass);
      const PairLaws& laws = setting.laws.at(bodies.material[i], bodies.material[j]);
      const Vec3 force =
          force_on_second<cohesive>(laws, meet, two.velocity - one.velocity, effective_mass, log);
      log.pair_force(bodies, i, j, force);
      on_one -= force;
      bodies.acceleration[j] += force;
    }
    bodies.acceleration[i] = on_one;
  }
}

template <bool cohesive, class Shape, class Log>
void add_wall_force(const ContactSetting& setting, const Shape& shape, std::size_t wall, std::int32_t i,
                    Bodies& bodies, Watch& watch, Log& log) {
  const Body& body = bodies.body[i];
  const auto [normal, distance] = nearest(shape, body.position, setting.box);
  const double range = cohesive ? bodies.reach[i] : body.radius;
  if (distance >= range) return;
  const Encounter meet{no_particle, i, normal, body.radius - distance, range - distance};
  if (meet.overlap > watch.overlap_limit() * body.radius) [[unlikely]]
    watch.report({Trouble::Kind::wall_too_deep, i, static_cast<std::int32_t>(wall), meet.overlap});
  const PairLaws& laws = setting.laws.at(setting.walls[wall].material, bodies.material[i]);
  const Vec3 force = force_on_second<cohesive>(laws, meet, body.velocity, 1.0 / body.inverse_mass, log);
  log.wall_force(wall, force);
  bodies.acceleration[i] += force;
}

template <bool cohesive, class Log>
void add_wall_forces(const ContactSetting& setting, const NearWalls& near, Bodies& bodies, Watch& watch,
                     Log& log) {
  for (std::size_t wall = 0; wall < setting.walls.size(); ++wall)
    std::visit(
        [&](const auto& shape) {
          for (const std::int32_t i : near.near(wall))
            add_wall_force<cohesive>(setting, shape, wall, i, bodies, watch, log);
        },
        setting.walls[wall].shape);
}

template <bool periodic, bool cohesive>
void add_forces(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies, Watch& watch,
                ForceLog* log) {
  const auto add = [&](auto& used) {
    add_pair_forces<periodic, cohesive>(setting, neighbours.pairs(), bodies, watch, used);
    add_wall_forces<cohesive>(setting, neighbours.walls(), bodies, watch, used);
  };
  NoLog none;
  log ? add(*log) : add(none);
}

}  // namespace

void add_contact_forces(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies,
                        Watch& watch, ForceLog* log) {
  const auto add = setting.box.any()
                       ? (setting.cohesion ? add_forces<true, true> : add_forces<true, false>)
                       : (setting.cohesion ? add_forces<false, true> : add_forces<false, false>);
  add(setting, neighbours, bodies, watch, log);
}

}  // namespace grainproof::reference
