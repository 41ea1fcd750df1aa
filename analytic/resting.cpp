// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/resting.hpp"

#include "analytic/contact_scales.hpp"

namespace grainproof::analytic {

std::string why_no_rest(const Encounter& encounter) {
  if (encounter.cohesion_stiffness() > 0.0) return "cohesion acts";
  if (!(encounter.gravity < 0.0)) return "gravity does not pull towards the partner";
  return {};
}

double resting_overlap(const Encounter& encounter) {
  return -encounter.mass * encounter.gravity / encounter.normal_law().stiffness;
}

Solution come_to_rest(const Scene& scene, const Encounter& encounter, double until) {
  if (const std::string because = why_no_rest(encounter); !because.empty()) return Solution::no(because);
  if (!slides_freely(encounter))
    return Solution::no("friction acts, or the fall is not along the line of centres");
  const Vec3 ran = (encounter.slip + 0.5 * until * encounter.gravity_across) * until;
  if (!over_wall(encounter, ran)) return Solution::no("the sphere runs off the wall's edge");
  const Passage passage(encounter, until);
  Solution solution = solution_of(scene, encounter, passage);
  if (const auto contact = passage.first_contact()) add_contact_scalars(solution, *contact);
  solution.scalars["resting_overlap"] = resting_overlap(encounter);
  return solution;
}

}  // namespace grainproof::analytic
