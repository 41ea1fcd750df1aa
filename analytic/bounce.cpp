// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/resting.hpp"

/// A sphere falls on its partner and bounces until a contact no longer ends: linear.11.
namespace grainproof::analytic {

Solution bounce(const Scene& scene, double until) {
  const Recognised found = recognise(scene);
  if (!found.support) return Solution::no(found.support.because);
  if (!(found.encounter.gap.position > 0.0)) return Solution::no("the sphere starts in contact");
  return come_to_rest(scene, found.encounter, until);
}

}  // namespace grainproof::analytic
