// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/scene.hpp"

/// Isolated pairs that each collide once: random direction, speed, diameters and moment of touching, so that
/// no phase or ratio of step to contact is favoured. What each pair's velocity becomes is known.
namespace grainproof::bench {

struct PairGas {
  std::string name;  ///< "head_on", "elastic", "hertz", "oblique", "cohesive", "drag", "pair_gas"
  std::int64_t pairs;
  double restitution;
  bool hertz = false;
  bool oblique = false;     ///< with sliding, history friction and rotation
  bool cohesive = false;    ///< attraction that begins a fiftieth of a diameter apart
  bool drag = false;        ///< in a still fluid that slows the bodies down within some contacts
  double spread = 0.2;      ///< of diameters, about the usual one
  double counted_in = 1.2;  ///< diameters of the spheres whose contact steps are counted in

  /// Whether each pair's rebound is known as a number.
  bool closed_form() const { return !oblique && !cohesive && !drag; }
};

/// Those of the suite; "pair_gas" is the one whose time counts.
std::vector<PairGas> pair_gases(bool quick);

/// At `steps_per_contact` steps of a contact of PairGas::counted_in, a whole number of them until every pair
/// has parted.
Scene pair_scene(const PairGas& gas, double steps_per_contact);

/// Of the viscosity that PairGas::drag has, Pa s.
double pair_viscosity();

/// Relative velocity of each pair, second minus first.
std::vector<Vec3> relative_velocities(const std::vector<Vec3>& velocity);

/// Of each pair after a head-on collision that leaves with `restitution` times the speed: the closed form.
std::vector<Vec3> rebounds(const Scene& scene, const std::vector<double>& restitution);

/// Root of the mean squared distance of two sets, each pair's over its own speed at the start.
double rms_error(const std::vector<Vec3>& found, const std::vector<Vec3>& exact,
                 const std::vector<Vec3>& start);

/// Of a linear contact: π/ω_d at this restitution.
double contact_time(double effective_mass, double restitution);

double effective_mass_of_pair(const Scene& scene, std::size_t pair);

}  // namespace grainproof::bench
