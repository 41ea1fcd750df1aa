// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/onset/boundary_step.hpp"

#include <type_traits>

#include "reference_cpu/contact_loops.hpp"
#include "reference_cpu/onset/beginning.hpp"
#include "reference_cpu/onset/bends.hpp"
#include "reference_cpu/onset/parting.hpp"

namespace grainproof::reference {
namespace {

/// All that the evaluation is told.
struct Scope {
  const ContactSetting& setting;
  const BoundaryStep& now;
  const Neighbours& neighbours;
  Bodies& bodies;
  ContactHistory& history;
  Touching& touching;
  Watch& watch;
  OnsetEvents& events;
};

Encounter pair_now(const Scope& scope, std::int32_t i, std::int32_t j) {
  const Body& one = scope.bodies.body[i];
  const Body& two = scope.bodies.body[j];
  const Vec3 apart = scope.setting.box.nearest_image(two.position - one.position);
  const double distance = apart.norm();
  return {i, j, apart * (1.0 / distance), one.radius + two.radius - distance, 0.0};
}

Encounter wall_now(const Scope& scope, std::int32_t wall, std::int32_t i) {
  const Body& body = scope.bodies.body[i];
  const WallNow& stands = scope.setting.walls[wall];
  const auto [normal, distance] = std::visit(
      [&](const auto& shape) { return nearest(shape, body.position, scope.setting.box); }, stands.shape);
  Encounter meet{wall_as_body(wall), i, normal, body.radius - distance, 0.0};
  if (stands.moving) meet.wall_velocity = stands.velocity_at(body.position - distance * normal);
  return meet;
}

const ContactSprings& springs_of(const ContactHistory::Memory& memory) {
  return memory.springs;
}

ContactSprings springs_of(const Touching::Memory&) {
  return {};
}

template <class Memory, class Touch>
void end_contact(const Scope& scope, const Memory& memory, Touch& touch) {
  const Bodies& bodies = scope.bodies;
  const auto particles = static_cast<std::int32_t>(bodies.size());
  const std::int32_t j = memory.second, wall = memory.first - particles;
  if (wall >= 0) {
    const PairLaws& laws = scope.setting.laws.at(scope.setting.walls[wall].material, bodies.material[j]);
    touch.end(laws, wall_now(scope, wall, j), 1.0 / bodies.body[j].inverse_mass, springs_of(memory));
    return;
  }
  const std::int32_t i = memory.first;
  const double effective_mass = 1.0 / (bodies.body[i].inverse_mass + bodies.body[j].inverse_mass);
  const PairLaws& laws = scope.setting.laws.at(bodies.material[i], bodies.material[j]);
  touch.end(laws, pair_now(scope, i, j), effective_mass, springs_of(memory));
}

template <bool turning, bool cohesive, bool corrects, class Memory, class Log>
void add_forces(const Scope& scope, Memory& memory, Log& log) {
  using Touch = BoundaryTouch<turning, cohesive, corrects, Memory, Log>;
  Touch touch(scope.setting.walls, scope.bodies, scope.history, memory, log, scope.now, scope.events);
  add_forces_by(scope.setting, scope.neighbours, scope.bodies, scope.watch, touch, log);
  if constexpr (corrects)
    if (scope.now.started)
      for (const auto& parted : memory.parted()) end_contact(scope, parted, touch);
}

/// Cohesion is left out only where that is worth a loop of its own.
template <bool turning, class Memory, class Log>
void add_corrected(const Scope& scope, Memory& memory, Log& log) {
  if constexpr (std::is_same_v<Log, NoLog>)
    if (!scope.setting.cohesion) return add_forces<turning, false, true>(scope, memory, log);
  add_forces<turning, true, true>(scope, memory, log);
}

template <bool turning, class Log>
void add_as_corrected(const Scope& scope, Log& log) {
  if (!scope.now.corrects) return add_forces<turning, true, false>(scope, scope.history, log);
  if constexpr (!turning)
    if (scope.setting.simple) return add_corrected<turning>(scope, scope.touching, log);
  add_corrected<turning>(scope, scope.history, log);
}

template <class Log>
void add_any_forces(const Scope& scope, Log& log) {
  scope.bodies.turning() ? add_as_corrected<true>(scope, log) : add_as_corrected<false>(scope, log);
}

}  // namespace

void add_boundary_forces(const ContactSetting& setting, const BoundaryStep& now, const Neighbours& neighbours,
                         Bodies& bodies, ContactHistory& history, Touching& touching, Watch& watch,
                         ForceLog* log, OnsetEvents& events) {
  const Scope scope{setting, now, neighbours, bodies, history, touching, watch, events};
  NoLog none;
  log ? add_any_forces(scope, *log) : add_any_forces(scope, none);
}

}  // namespace grainproof::reference
