// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "opencl/limits.hpp"

namespace grainproof::opencl {

// Lists and tables go by whole steps, and a step of pefrl asks for forces four times on its way.
Support composition_within_limits(const Scene& scene, const Request& request, bool small) {
  if (scene.run.integrator != Integrator::pefrl) return {};
  if (request.ledger)
    return Support::no(
        "the ledger needs forces at the boundary of a step, where pefrl evaluates none; take "
        "velocity_verlet");
  if (!small)
    return Support::no("pefrl is built for the small path, of up to 64 particles; take onset_corrected");
  if (std::holds_alternative<RotatingGravity>(scene.gravity))
    return Support::no("pefrl is not built for gravity that rotates, which is tabled by whole steps");
  const auto moves = [](const Wall& wall) { return !std::holds_alternative<Still>(wall.motion); };
  if (std::ranges::any_of(scene.walls, moves))
    return Support::no("pefrl is not built for walls that move, which are tabled by whole steps");
  return {};
}

}  // namespace grainproof::opencl
