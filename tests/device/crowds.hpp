// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"

namespace grainproof::opencl::testing {

/// What a crowd can be made of; the default is a thousand equal spheres with every law of a dense bed.
struct Crowd {
  int across = 10;  ///< spheres along x and y
  int layers = 10;
  double spread = 0.0;  ///< of diameters below 0.1 m, as a fraction
  FrictionLaw friction = HistoryFriction{0.5, 8e4, 0.5};
  bool rotation = true;
  bool no_tension = false;
  bool fixed = false;  ///< every seventh one
  std::array<Boundary, 3> boundary{Boundary::periodic, Boundary::periodic, Boundary::wall};
};

/// Spheres in random motion that press each other from the start, on a lattice shaken a little.
Scene crowded_scene(const Crowd& crowd);

inline constexpr int crowd_steps = 150;

}  // namespace grainproof::opencl::testing
