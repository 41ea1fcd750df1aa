// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "analytic/contact_scales.hpp"
#include "analytic/passage_solution.hpp"

/// Head-on collision without gravity: linear.4 to linear.9.
namespace grainproof::analytic {

Solution normal_collision(const Scene& scene, double) {
  const Recognised found = recognise(scene);
  if (!found.support) return Solution::no(found.support.because);
  const Encounter& encounter = found.encounter;
  if (encounter.cohesion_stiffness() > 0.0) return Solution::no("cohesion acts");
  if (encounter.gravity != 0.0 || !encounter.gravity_across.isZero(0.0)) return Solution::no("gravity acts");
  if (!slides_freely(encounter)) return Solution::no("the velocity is not along the line of centres");
  const Passage passage(encounter, std::numeric_limits<double>::infinity());
  const auto contact = passage.first_contact();
  if (!contact) return Solution::no("the bodies never touch");
  Solution solution = solution_of(scene, encounter, passage);
  add_contact_scalars(solution, *contact);
  // A contact that only creeps apart has no end: its rebound is zero.
  if (!contact->end) solution.scalars["restitution"] = 0.0;
  return solution;
}

}  // namespace grainproof::analytic
