// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/hertz_encounter.hpp"

namespace grainproof::analytic {

HertzPair hertz_pair_of(const Scene& scene, const Encounter& e) {
  const Particle& two = scene.particles[e.second];
  const std::size_t partner = e.first ? scene.particles[*e.first].material : scene.walls.front().material;
  const double partner_radius =
      e.first ? 0.5 * scene.particles[*e.first].diameter : std::numeric_limits<double>::infinity();
  return hertz_pair(scene, {partner, static_cast<std::size_t>(two.material)}, e.mass,
                    effective_radius(partner_radius, 0.5 * two.diameter),
                    std::get<HertzNormal>(e.laws.normal));
}

}  // namespace grainproof::analytic
