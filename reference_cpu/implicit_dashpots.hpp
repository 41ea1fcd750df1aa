// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/contacts.hpp"

/// Forces for velocity_verlet_implicit, in two evaluations a step (docs/laws/integrators.md).
namespace grainproof::reference {

/// What acts without dashpots: springs, stretched with the velocities as they are for as long as the history
/// says and not yet cut back by the Coulomb limit. Otherwise as add_contact_forces().
void add_spring_forces(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies,
                       ContactHistory& history, Watch& watch);

/// All forces, with springs as the evaluation before has left them, and dashpots that take what they leave of
/// the velocities as they are, in half of `step` (s). Otherwise as add_contact_forces().
void add_forces_with_implicit_dashpots(const ContactSetting& setting, double step,
                                       const Neighbours& neighbours, Bodies& bodies, ContactHistory& history,
                                       Watch& watch, ForceLog* log);

}  // namespace grainproof::reference
