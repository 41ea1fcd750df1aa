// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "model/scene.hpp"

/// Arrangements of spheres at rest in which every contact is kept: docs/stability.md.
namespace grainproof::bench {

struct StabilityCase {
  std::string arrangement;       ///< "pair", "wall", "chain", "simple_cubic", "face_centred", "random_8", …
  std::string restitution;       ///< "0.8", "none" without a dashpot, "overdamped" at twice the critical one
  double mass_ratio = 1.0;       ///< of the heavy to the light bodies
  double stiffness_ratio = 1.0;  ///< of contacts of heavy bodies to those of light ones
  std::string friction = "none";  ///< "history", "step", "collision_time", "damped"; bodies turn with any
};

/// At rest and in equilibrium, with velocity Verlet and no step. Throws InputRefused for an arrangement that
/// is not known.
Scene resting_scene(const StabilityCase& of);

/// Overlap, or gap, of the two bodies that are nearest to losing or making their contact, m.
double least_slack(const Scene& scene);

/// Of the body with most.
int most_contacts(const Scene& scene);

/// Duration of the shortest contact, s.
double contact_time_of(const Scene& scene);

/// Packed at random: pressed on until some body has `contacts`; the largest overlap is a few hundredths of d.
void fill_packing(Scene& scene, int contacts);

/// Displacement from body `one` to `other`, through the nearest faces.
Vec3 apart(const Scene& scene, std::size_t one, std::size_t other);

}  // namespace grainproof::bench
