// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

#include "model/fields.hpp"
#include "model/integrators.hpp"
#include "reference_cpu/bodies.hpp"

namespace grainproof::reference {

/// One step is move(), the forces at the new place and time, and settle() where there is one. Both
/// return for how long (s) they have applied the acceleration, which the ledger needs.
/// The equations are in docs/laws/integrators.md.
struct Scheme {
  double (*move)(Bodies& bodies, const Flow& flow, double step, std::int64_t steps_done);
  double (*settle)(Bodies& bodies, double step) = nullptr;
  bool applies_drag = false;  ///< then drag is left out of the acceleration
  double velocity_lag = 0.0;  ///< of the velocity it holds, in steps
  double move_lag = 0.0;      ///< after move(), steps back to the velocity that took bodies along
};

Scheme euler_trapezoid();
Scheme euler_trapezoid_implicit_drag();
Scheme leapfrog_verlet();
Scheme velocity_verlet();
/// Of onset_corrected too, which only evaluates forces in its own way.
Scheme velocity_verlet_predicted();

inline Scheme scheme_for(Integrator integrator) {
  switch (integrator) {
    case Integrator::euler_trapezoid:
      return euler_trapezoid();
    case Integrator::euler_trapezoid_implicit_drag:
      return euler_trapezoid_implicit_drag();
    case Integrator::leapfrog_verlet:
      return leapfrog_verlet();
    case Integrator::velocity_verlet:
      return velocity_verlet();
    case Integrator::velocity_verlet_predicted:
    case Integrator::onset_corrected:
      return velocity_verlet_predicted();
  }
  return velocity_verlet();
}

}  // namespace grainproof::reference
