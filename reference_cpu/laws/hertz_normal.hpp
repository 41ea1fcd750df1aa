// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/laws.hpp"
#include "model/materials.hpp"
#include "reference_cpu/laws/tangential_spring.hpp"

namespace grainproof::reference {

/// Hertz and Mindlin contact of one pair of materials (docs/laws/hertz.md). Everything follows from
/// the radius of the contact circle a = sqrt(R* δ), with R* = r1 r2/(r1 + r2).
struct HertzContact {
  double modulus = 0.0;        ///< E*, Pa; zero is a linear contact
  double shear_modulus = 0.0;  ///< G*, Pa
  double damping_share = 0.0;  ///< η over sqrt(m k), of the normal and of the tangential dashpot

  bool present() const { return modulus != 0.0; }

  double push(double circle, double overlap) const { return 4.0 / 3.0 * modulus * circle * overlap; }
  double potential(double circle, double overlap) const {
    return 8.0 / 15.0 * modulus * circle * overlap * overlap;
  }
  double damping(double circle, double root_mass) const;
  ShearResponse shear(double circle, double root_mass) const;

  /// Of an undamped impact that goes just as deep as this, s.
  double contact_time(double circle, double mass) const;
};

HertzContact hertz_contact(const HertzNormal& law, const Elasticity& one, const Elasticity& two);

}  // namespace grainproof::reference
