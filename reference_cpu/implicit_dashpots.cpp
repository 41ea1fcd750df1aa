// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/implicit_dashpots.hpp"

#include "reference_cpu/contact_loops.hpp"
#include "reference_cpu/implicit_touch.hpp"

namespace grainproof::reference {
namespace {

template <bool turning>
void add_springs(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies,
                 ContactHistory& history, Watch& watch) {
  NoLog none;
  add_forces_by(setting, neighbours, bodies, watch,
                SpringTouch<turning>(setting.walls, bodies, history, none), none);
}

template <bool turning, class Log>
void add_all(const ContactSetting& setting, double step, const Neighbours& neighbours, Bodies& bodies,
             ContactHistory& history, Watch& watch, Log& log) {
  add_forces_by(setting, neighbours, bodies, watch,
                DashpotTouch<turning, Log>(setting.walls, bodies, history, log, step), log);
}

template <class Log>
void add_any(const ContactSetting& setting, double step, const Neighbours& neighbours, Bodies& bodies,
             ContactHistory& history, Watch& watch, Log& log) {
  bodies.turning() ? add_all<true>(setting, step, neighbours, bodies, history, watch, log)
                   : add_all<false>(setting, step, neighbours, bodies, history, watch, log);
}

}  // namespace

void add_spring_forces(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies,
                       ContactHistory& history, Watch& watch) {
  bodies.turning() ? add_springs<true>(setting, neighbours, bodies, history, watch)
                   : add_springs<false>(setting, neighbours, bodies, history, watch);
}

void add_forces_with_implicit_dashpots(const ContactSetting& setting, double step,
                                       const Neighbours& neighbours, Bodies& bodies, ContactHistory& history,
                                       Watch& watch, ForceLog* log) {
  NoLog none;
  log ? add_any(setting, step, neighbours, bodies, history, watch, *log)
      : add_any(setting, step, neighbours, bodies, history, watch, none);
}

}  // namespace grainproof::reference
