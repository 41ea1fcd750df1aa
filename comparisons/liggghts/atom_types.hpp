// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::liggghts {

/// Particles that behave alike in every contact; LIGGGHTS keeps its parameters by pair of atom types.
struct AtomType {
  std::int32_t material = 0;
  double mass = 0.0;  ///< kg; 0 for a wall
  double diameter = 0.0;
  bool moves = true;  ///< false for fixed particles and walls
};

/// Parameters of one pair of types, in LIGGGHTS' terms.
struct PairParameters {
  double stiffness = 1.0;           ///< kn, N/m
  double damping = 0.0;             ///< gamman_abs, N s/m
  double tangential_damping = 0.0;  ///< gammat_abs, N s/m
  double friction = 0.0;            ///< coefficientFriction
};

/// A scene's atom types, those of its walls last.
struct TypeTable {
  std::vector<AtomType> types;
  std::vector<std::size_t> of_particle;  ///< by particle
  std::vector<std::size_t> of_wall;      ///< by wall
  bool no_tension = false;               ///< limitForce
};

TypeTable atom_types(const Scene& scene);

/// docs/laws/linear.md and friction.md, for the effective mass of the pair. With tangential no_history
/// LIGGGHTS has −min(γ_t |u_t|, μ |F_n|): every static variant that is linear in the slip is a γ_t,
/// and dynamic friction a γ_t without bound.
PairParameters pair_parameters(const Scene& scene, const AtomType& a, const AtomType& b);

/// Dashpot of a contact with effective mass m that rebounds with the law's restitution, N s/m.
double damping_of(const LinearNormal& law, double mass);

}  // namespace grainproof::liggghts
