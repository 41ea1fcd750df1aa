// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/contact_history.hpp"
#include "reference_cpu/force_log.hpp"
#include "reference_cpu/neighbours/neighbours.hpp"
#include "reference_cpu/walls.hpp"
#include "reference_cpu/watch.hpp"

namespace grainproof::reference {

/// What contacts are made of besides the particles; all of it outlives the call.
struct ContactSetting {
  const LawTable& laws;
  const PeriodicBox& box;
  const Walls& walls;
  bool cohesion;
  bool simple;  ///< linear springs and friction without memory only
};

/// Adds the forces of all contacts to bodies.acceleration: for each particle those of its partners
/// by rising id, then those of the walls by rising index. Torques likewise to bodies.angular_acceleration,
/// where bodies turn. `history` has been begun. `log` may be null.
void add_contact_forces(const ContactSetting& setting, const Neighbours& neighbours, Bodies& bodies,
                        ContactHistory& history, Watch& watch, ForceLog* log);

}  // namespace grainproof::reference
