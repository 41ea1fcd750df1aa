// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "analytic/encounter.hpp"
#include "analytic/passage.hpp"
#include "analytic/solution.hpp"

namespace grainproof::analytic {

/// Frames of a passage whose motion across the normal nothing but gravity changes.
Solution solution_of(const Scene& scene, const Encounter& encounter, const Passage& passage);

/// contact_onset_time, peak_overlap; contact_duration and restitution where the contact has an end;
/// force_duration where the force falls to zero before that.
void add_contact_scalars(Solution& solution, const Passage::Contact& contact);

/// Largest stable step of the scene's integrator on this contact.
double stable_step(const Scene& scene, const Encounter& encounter);

/// Whether the motion across the normal can be taken as force-free: head-on, or a wall without friction.
bool slides_freely(const Encounter& encounter);

}  // namespace grainproof::analytic
