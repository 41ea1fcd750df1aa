// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <utility>

#include "model/observations.hpp"
#include "model/scene.hpp"
#include "report/contacts.hpp"

namespace grainproof::report {

/// What one frame alone tells of energy, J: nothing has to be kept on the way.
struct Energies {
  double kinetic = 0.0;                 ///< of centres and of spins
  double elastic = 0.0;                 ///< in normal springs; what tangential ones hold is not seen
  std::optional<double> gravitational;  ///< from the origin; none unless gravity is constant and no face that
                                        ///< it crosses periodic
};

/// J; a frame has all particles of the scene, in its order.
Energies energies_of(const Scene& scene, const Frame& frame);

/// The same, with what touches counted on the way.
Energies energies_of(const Scene& scene, const Frame& frame, ContactCount& contacts);

/// Of one particle; a fixed one has none.
double kinetic_energy(const Scene& scene, const Frame& frame, std::size_t particle);

/// In the normal springs of all that touches, weighted by `share` of its laws.
using Share = double (*)(const ContactLaws&);
double energy_of_overlaps(const Scene& scene, const Frame& frame, Share share,
                          ContactCount* contacts = nullptr);

}  // namespace grainproof::report
