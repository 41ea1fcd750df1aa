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

/// docs/laws/history.md; with Hertz the stiffness and the damping rise with the overlap.
struct HistoryCoefficients {
  double coefficient = 0.0;  ///< 0 without
  double stiffness = 0.0;
  MassLaw damping;
  CoulombLimit limit{};
  TorqueArm arm{};
  SpringTurn turn{};
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
  bool hertz = false;  ///< stiffness in Pa, to be multiplied by sqrt(R* δ); damping by its root
  HistoryCoefficients history;
};

/// Laws of materials `a` and `b`. Throws InputRefused for what the equations cannot give.
PairCoefficients coefficients_of(const Scene& scene, std::size_t a, std::size_t b);

/// Dashpot of a normal law. Throws InputRefused for a restitution that a clamped contact cannot have.
MassLaw damping_of(const LinearNormal& law);

/// Of a Hertz contact, times sqrt(sqrt(R* δ)). Throws InputRefused where it is given in N s/m.
MassLaw damping_of(const HertzNormal& law, double youngs_modulus);

/// E* and G* of two materials, Pa. docs/laws/hertz.md
struct EffectiveModuli {
  double youngs;
  double shear;
};
EffectiveModuli effective_moduli(const Material& a, const Material& b);

/// Damping ratio η/(2 sqrt(mk)) with which a contact that never pulls rebounds with `restitution`.
double damping_ratio_without_tension(double restitution);

/// 2/5 m r² of a solid sphere.
double inertia_of(const Particle& particle, const Scene& scene);

double mass_of(const Particle& particle, const Scene& scene);

/// Shortest undamped contact π sqrt(m/k) that a moving particle of the scene can have, s; 0 without any
/// linear one.
double shortest_contact(const Scene& scene);

}  // namespace grainproof::opencl
