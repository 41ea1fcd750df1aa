// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/resting.hpp"

/// A sphere settles to the overlap m g/k, from wherever it starts: linear.10.
namespace grainproof::analytic {

Solution settling(const Scene& scene, double until) {
  const Recognised found = recognise(scene);
  if (!found.support) return Solution::no(found.support.because);
  return come_to_rest(scene, found.encounter, until);
}

}  // namespace grainproof::analytic
