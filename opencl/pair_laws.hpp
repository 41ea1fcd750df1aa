// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "model/scene.hpp"

namespace grainproof::opencl {

/// A coefficient c_0 + c_1 sqrt(m) of the effective mass m, which a kernel knows only when two bodies meet.
struct MassLaw {
  double constant = 0.0;
  double per_root_mass = 0.0;

  double at(double mass) const;
};

/// Laws of one pair of materials as the kernels take them. docs/laws/linear.md, friction.md, cohesion.md
struct PairCoefficients {
  double stiffness = 0.0;
  MassLaw damping;
  bool no_tension = false;
  double friction = 0.0;
  MassLaw viscosity;       ///< static limit per slip speed
  bool unlimited = false;  ///< no static limit: μ|F_n| at any slip
  double cohesion = 0.0;
};

/// `step` in s; only step friction needs it.
PairCoefficients coefficients_of(const ContactLaws& laws, double step);

/// Dashpot of a normal law. Throws InputRefused for a restitution that a clamped contact cannot have.
MassLaw damping_of(const LinearNormal& law);

/// Damping ratio η/(2 sqrt(mk)) with which a contact that never pulls rebounds with `restitution`.
double damping_ratio_without_tension(double restitution);

double mass_of(const Particle& particle, const Scene& scene);

/// Shortest undamped contact π sqrt(m/k) that a moving particle of the scene can have, s; 0 without any.
double shortest_contact(const Scene& scene);

}  // namespace grainproof::opencl
