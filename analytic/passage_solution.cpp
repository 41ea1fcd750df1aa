// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/passage_solution.hpp"

#include "analytic/contact_scales.hpp"

namespace grainproof::analytic {

Solution solution_of(const Scene& scene, const Encounter& encounter, const Passage& passage) {
  Solution solution;
  solution.frame_at = [scene, encounter, passage](double time) {
    const Slip slip{(encounter.slip + 0.5 * time * encounter.gravity_across) * time,
                    encounter.slip + time * encounter.gravity_across};
    return frame_of(scene, encounter, passage.at(time), slip, time);
  };
  solution.scalars["stable_step"] = stable_step(scene, encounter);
  return solution;
}

void add_contact_scalars(Solution& solution, const Passage::Contact& contact) {
  solution.scalars["contact_onset_time"] = contact.onset;
  solution.scalars["peak_overlap"] = contact.peak_overlap;
  if (contact.released) solution.scalars["force_duration"] = *contact.released - contact.onset;
  if (!contact.end) return;
  solution.scalars["contact_duration"] = *contact.end - contact.onset;
  if (contact.entry_speed > 0.0) solution.scalars["restitution"] = contact.exit_speed / contact.entry_speed;
}

double stable_step(const Scene& scene, const Encounter& e) {
  return pair_stability_limit(scene.run.integrator, e.mass, e.normal_law().stiffness,
                              damping(e.normal_law(), e.mass));
}

bool slides_freely(const Encounter& e) {
  return head_on(e) || (!e.first && std::holds_alternative<Frictionless>(e.laws.friction));
}

}  // namespace grainproof::analytic
