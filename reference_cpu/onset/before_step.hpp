// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/contact_force.hpp"

namespace grainproof::reference {

/// Share of the predicted velocity that a dashpot sees, once the spring beside it has had its say:
/// (1 + c)/(1 + c + κ) (docs/laws/integrators.md).
inline double refined_share(double stiffness, double damping, double inverse_mass, double step) {
  const double twice = 0.5 * step * inverse_mass;
  const double with_damping = 1.0 + twice * damping;
  return with_damping / (with_damping + twice * step * stiffness);
}

/// Where two bodies stood at the start of the step in which they parted.
struct BeforeParting {
  ContactPoint point;
  Vec3 slip;
  Vec3 gain;     ///< what the slip would gain in the step by the accelerations then, m/s
  Vec3 rolling;  ///< spin of body 2 over body 1, as rolling resistance takes it, rad/s
};

/// What spring and dashpot against slip make together, whatever the limit, and the limit, N.
struct Grip {
  Vec3 pull;
  double most;
};

}  // namespace grainproof::reference
