// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "analytic/contact_scales.hpp"
#include "analytic/possible_contacts.hpp"

namespace grainproof::analytic {

/// What one possible contact is made of, at its stiffest.
struct ContactLoad {
  PossibleContact contact;
  ContactScale scale;
  double tangential_stiffness = 0.0;  ///< of a spring that remembers; 0 without one
  double tangential_damping = 0.0;
  double creep_stiffness = 0.0;  ///< of friction without memory: times the step its dashpot (friction.2)
  double creep_damping = 0.0;    ///< that dashpot where the step has no part in it, at the heaviest partner
  double crowded_damping = 1.0;  ///< by how much more the heaviest partner is damped; restitution makes it so
  double turning = 1.0;          ///< by how much more a force moves the point of contact than the centre
  double spin = 0.0;  ///< share of that which is turning, springs against rolling included (stability.7)
};

/// Largest step at which bodies with as many contacts at once as the scene has room for are stable, and
/// which; infinity where no body can have two. A bound: rarely the limit itself (docs/stability.md).
StepLimit crowd_limit(const Scene& scene, const std::vector<ContactLoad>& loads);

}  // namespace grainproof::analytic
