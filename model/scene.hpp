// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/fields.hpp"
#include "model/integrators.hpp"
#include "model/materials.hpp"
#include "model/particle.hpp"
#include "model/state.hpp"
#include "model/walls.hpp"

namespace grainproof {

enum class Boundary { open, periodic, wall };

/// The box that particles live in. Leaving it through a face that is not periodic ends the run.
struct Domain {
  Vec3 lower;
  Vec3 upper;
  std::array<Boundary, 3> boundary{Boundary::open, Boundary::open, Boundary::open};

  Vec3 extent() const { return upper - lower; }
  bool periodic(int axis) const { return boundary[axis] == Boundary::periodic; }
};

/// How orientations are advanced, docs/laws/rotation.md. Spheres don't feel them: kept only where asked for.
enum class OrientationUpdate {
  none,
  exponential,    ///< the exact turn of a constant spin over the step; unit length kept
  forward_euler,  ///< q + ½ Δt ω q, as printed by Bilock: first order, and its length grows (E14)
};

/// In which order the forces on a particle are summed; see docs/determinism.md.
enum class SumOrder { fast, canonical };

/// How a contact list is found. `automatic` leaves the choice to the engine.
enum class NeighbourSearch { automatic, all_pairs, cells, verlet_list };

struct RunSettings {
  double end;   ///< s
  double step;  ///< s
  Integrator integrator = Integrator::velocity_verlet;
  SumOrder order = SumOrder::fast;
  NeighbourSearch neighbours = NeighbourSearch::automatic;
  double skin = -1.0;                            ///< m; negative leaves it to the engine
  static constexpr double searched_skin = -2.0;  ///< left to the engine, which is to look for the best
  double overlap_limit = 0.5;        ///< fraction of the smaller radius; a deeper contact ends the run
  std::vector<double> sample_times;  ///< s, increasing; the first is 0 and the last is `end`
};

/// What an engine is given: complete, checked, with every number resolved.
struct Scene {
  std::string title;
  RunSettings run;
  Domain domain;
  std::vector<Material> materials;
  ContactTable contacts;
  std::vector<Particle> particles;  ///< ids unique and increasing
  std::vector<Wall> walls;          ///< walled faces of the domain included
  /// What contacts remember at the start, sorted by first and second; a contact not named here is new.
  std::vector<ContactMemory> remembered = {};
  Gravity gravity = ConstantGravity{Vec3::Zero()};
  Flow flow = NoFlow{};
  bool rotation = false;  ///< bodies turn; else nothing that has to do with turning is computed
  OrientationUpdate orientation = OrientationUpdate::none;  ///< needs `rotation`
};

}  // namespace grainproof
