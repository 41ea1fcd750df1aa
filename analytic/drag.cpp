// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/contact_scales.hpp"
#include "analytic/free_motion.hpp"
#include "analytic/possible_contacts.hpp"

/// Stokes drag in a uniform stream, with or without constant gravity: fields.6.
namespace grainproof::analytic {

Solution drag(const Scene& scene, double until) {
  const auto* flow = std::get_if<UniformFlow>(&scene.flow);
  if (!flow) return Solution::no("there is no uniform flow");
  const auto* gravity = std::get_if<ConstantGravity>(&scene.gravity);
  if (!gravity) return Solution::no("gravity is not constant");
  Solution solution = free_motion(scene, gravity->acceleration, *flow, until);
  if (!solution.support) return solution;
  double rate = 0.0;
  for (const Particle& particle : scene.particles)
    rate = std::max(rate, drag_rate(*flow, scene.materials[particle.material].density, particle.diameter));
  if (rate > 0.0) {
    solution.scalars["relaxation_time"] = 1.0 / rate;
    const double limit = pair_stability_limit(scene.run.integrator, 1.0, 0.0, 0.0, rate);
    if (limit < std::numeric_limits<double>::infinity()) solution.scalars["stable_step"] = limit;
  }
  return solution;
}

}  // namespace grainproof::analytic
