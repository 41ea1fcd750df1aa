// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/periodic.hpp"

namespace grainproof::analytic {
namespace {

constexpr int looks = 1000;

bool clear_of_faces(const Scene& scene, const Frame& frame) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double reach = 0.5 * scene.particles[i].effect_diameter;
    for (int axis = 0; axis < 3; ++axis) {
      if (!scene.domain.periodic(axis)) continue;
      const double x = frame.position[i][axis];
      if (!(x - reach > scene.domain.lower[axis] && x + reach < scene.domain.upper[axis])) return false;
    }
  }
  return true;
}

}  // namespace

Solution solve_away_from_faces(Solution (*solve)(const Scene&, double), const Scene& scene, double until) {
  Scene open = scene;
  bool periodic = false;
  for (Boundary& boundary : open.domain.boundary) {
    if (boundary != Boundary::periodic) continue;
    boundary = Boundary::open;
    periodic = true;
  }
  Solution solution = solve(open, until);
  if (!periodic || !solution.support) return solution;
  for (int look = 0; look <= looks; ++look)
    if (!clear_of_faces(scene, solution.frame_at(until * look / looks)))
      return Solution::no("the domain is periodic, and a body reaches one of its faces");
  return solution;
}

}  // namespace grainproof::analytic
