// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "model/scene.hpp"

/// What LIGGGHTS and LAMMPS, which come from one code, have in common.
namespace grainproof::peers {

/// Particles that behave alike in every contact; both programs keep parameters by pair of atom types.
struct AtomType {
  std::int32_t material = 0;
  double mass = 0.0;  ///< kg; 0 for a wall
  double diameter = 0.0;
  bool moves = true;  ///< false for fixed particles and walls
};

/// A scene's atom types, those of its walls last.
struct TypeTable {
  std::vector<AtomType> types;
  std::vector<std::size_t> of_particle;  ///< by particle
  std::vector<std::size_t> of_wall;      ///< by wall
};

/// A type for every material, size and kind (moving, fixed, wall) that the scene has.
TypeTable atom_types(const Scene& scene);

/// Of two types that may touch, of which one moves at least; null where the scene has none for them.
const ContactLaws* laws_between(const Scene& scene, const AtomType& a, const AtomType& b);

/// What a pair of types needs for linear contacts (docs/laws/linear.md, friction.md, history.md), for its
/// effective mass. Without history both programs have −min(γ_t |u_t|, μ |F_n|): every static variant
/// that is linear in the slip is a γ_t, and dynamic friction a γ_t without bound.
struct PairParameters {
  double mass = 1.0;                  ///< effective, kg
  double stiffness = 1.0;             ///< N/m
  double damping = 0.0;               ///< N s/m
  double tangential_stiffness = 1.0;  ///< N/m; of history friction
  double tangential_damping = 0.0;    ///< N s/m
  double friction = 0.0;
  bool history = false;
  bool no_tension = false;
};

/// Defaults where the two have no linear contact.
PairParameters pair_parameters(const Scene& scene, const AtomType& a, const AtomType& b);

/// All laws of a scene, each pair of materials once.
std::vector<ContactLaws> all_laws(const Scene& scene);

}  // namespace grainproof::peers
