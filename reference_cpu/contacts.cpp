// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/contacts.hpp"

#include "reference_cpu/contact_loops.hpp"
#include "reference_cpu/touch.hpp"

namespace grainproof::reference {
namespace {

template <bool cohesive, class Log>
void add_forces(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies,
                ContactHistory& history, Watch& watch, Log& log) {
  const auto add = [&](const auto& touch) { add_forces_by(setting, neighbours, bodies, watch, touch, log); };
  if (bodies.turning())
    add(AnyTouch<true, cohesive, Log>(setting.walls, bodies, history, log));
  else if (!setting.simple)
    add(AnyTouch<false, cohesive, Log>(setting.walls, bodies, history, log));
  else
    add(SimpleTouch<cohesive, Log>(log));
}

template <class Log>
void add_logged_forces(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies,
                       ContactHistory& history, Watch& watch, Log& log) {
  setting.cohesion ? add_forces<true>(setting, neighbours, bodies, history, watch, log)
                   : add_forces<false>(setting, neighbours, bodies, history, watch, log);
}

}  // namespace

void add_contact_forces(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies,
                        ContactHistory& history, Watch& watch, ForceLog* log) {
  NoLog none;
  log ? add_logged_forces(setting, neighbours, bodies, history, watch, *log)
      : add_logged_forces(setting, neighbours, bodies, history, watch, none);
}

}  // namespace grainproof::reference
