// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <utility>

#include "model/scene.hpp"

/// What a Hertz contact's parameters say before anything runs. Equations in docs/laws/hertz.md.
namespace grainproof::analytic {

/// E* in Pa (hertz.1).
double hertz_modulus(const Elasticity& one, const Elasticity& other);

/// G* in Pa, Mindlin's (hertz.2), E13.
double mindlin_modulus(const Elasticity& one, const Elasticity& other);

/// R* in m (hertz.3); an infinite radius, a wall's, leaves the other.
double effective_radius(double radius_1, double radius_2);

/// Ratio β of a dashpot that rebounds with this restitution (hertz.6), or that is this share of the
/// critical one (hertz.14). Throws InputRefused for a restitution outside (0, 1], and for a plain dashpot.
double hertz_damping_ratio(const Dissipation& dissipation);

/// A pair that meets by Hertz' law.
struct HertzPair {
  double mass;                    ///< effective, kg
  double radius;                  ///< R*, m
  double modulus;                 ///< E*, Pa
  double shear_modulus;           ///< G*, Pa
  double damping_ratio;           ///< β
  double force_constant() const;  ///< K of f = K δ^(3/2), N/m^(3/2)

  double normal_stiffness(double overlap) const;      ///< k_n, N/m (hertz.5)
  double tangential_stiffness(double overlap) const;  ///< k_t, N/m (hertz.8)
  double damping(double stiffness) const;             ///< 2 β sqrt(5/6) sqrt(m k), N s/m (hertz.6)
  double peak_overlap(double speed) const;            ///< of an elastic impact, m (hertz.10)
  double duration(double speed) const;          ///< of an elastic impact, s; infinite at rest (hertz.11)
  double resting_overlap(double weight) const;  ///< m (hertz.12)
};

/// Throws InputRefused where one of the two materials, by index, has no elasticity.
HertzPair hertz_pair(const Scene& scene, const std::pair<std::size_t, std::size_t>& materials, double mass,
                     double radius, const HertzNormal& law);

}  // namespace grainproof::analytic
