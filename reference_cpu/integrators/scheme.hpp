// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>

#include "model/fields.hpp"
#include "model/integrators.hpp"
#include "reference_cpu/bodies.hpp"

namespace grainproof::reference {

/// A drift, the forces at its end and a kick, as shares of the step.
struct SubStep {
  double drift, kick;
};

/// One step is move(), the forces at the new place and time, and settle() where there is one. Both
/// return for how long (s) they have applied the acceleration, which the ledger needs.
/// The equations are in docs/laws/integrators.md.
struct Scheme {
  double (*move)(Bodies& bodies, const Flow& flow, double step, std::int64_t steps_done);
  double (*settle)(Bodies& bodies, double step) = nullptr;
  /// Between two evaluations, of the springs and of everything, where there are two.
  void (*foresee)(Bodies& bodies, double step) = nullptr;
  /// In place of all these, and the first drift once more at the end.
  std::span<const SubStep> substeps = {};
  bool applies_drag = false;  ///< then drag is left out of the acceleration
  double velocity_lag = 0.0;  ///< of the velocity it holds, in steps
  double move_lag = 0.0;      ///< after move(), steps back to the velocity that took bodies along
};

/// Positions and velocities alone, for `duration` (s).
void drift(Bodies& bodies, double duration);
void kick(Bodies& bodies, double duration);

Scheme euler_trapezoid();
Scheme euler_trapezoid_implicit_drag();
Scheme leapfrog_verlet();
Scheme velocity_verlet();
/// Of onset_corrected too, which only evaluates forces in its own way.
Scheme velocity_verlet_predicted();
Scheme velocity_verlet_implicit();
Scheme pefrl();

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
    case Integrator::velocity_verlet_implicit:
      return velocity_verlet_implicit();
    case Integrator::pefrl:
      return pefrl();
  }
  return velocity_verlet();
}

}  // namespace grainproof::reference
