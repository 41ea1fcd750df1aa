// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/contacts.hpp"
#include "reference_cpu/onset/events.hpp"
#include "reference_cpu/onset/touching.hpp"

namespace grainproof::reference {

/// One evaluation of forces with the velocities predicted for the step boundary.
struct BoundaryStep {
  double step;    ///< s
  bool started;   ///< false for the evaluation before the first step, in which nothing begins or ends
  bool corrects;  ///< for the time that contacts lasted

  /// In which a contact itself changes the velocities that its dashpots are told: before the first step those
  /// are known.
  double foresight() const { return started ? step : 0.0; }
};

/// As add_contact_forces(). Springs are stretched by what the half-step velocities have moved, as plain
/// velocity Verlet does it; all else sees the velocities predicted for the boundary. What began or ended is
/// added to `events`. Where all laws are simple, `touching` is used in place of the history.
void add_boundary_forces(const ContactSetting& setting, const BoundaryStep& now, const Neighbours& neighbours,
                         Bodies& bodies, ContactHistory& history, Touching& touching, Watch& watch,
                         ForceLog* log, OnsetEvents& events);

}  // namespace grainproof::reference
