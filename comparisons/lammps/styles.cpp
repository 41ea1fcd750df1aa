// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/lammps/styles.hpp"

#include "comparisons/peers/deck.hpp"

namespace grainproof::lammps {
namespace {

using peers::AtomType;

std::string linear_style(const Scene& scene, const AtomType& a, const AtomType& b) {
  const peers::PairParameters pair = peers::pair_parameters(scene, a, b);
  std::ostringstream out = peers::exact_text();
  out << (pair.history ? "hooke/history " : "hooke ") << pair.stiffness << ' ' << pair.tangential_stiffness
      << ' ' << pair.damping / pair.mass << ' ' << pair.tangential_damping / pair.mass << ' ' << pair.friction
      << " 1" << (pair.no_tension ? " limit_damping" : "");
  return out.str();
}

/// docs/laws/hertz.md: F = 4/3 E* sqrt(R*) δ^1.5 and k_t = 8 G* sqrt(R* δ); both constants are LAMMPS'
/// K_n and K_t. Only elastic contacts come here.
std::string hertz_style(const Scene& scene, const AtomType& a, const AtomType& b,
                        const FrictionLaw& friction) {
  const Elasticity one = *scene.materials[static_cast<std::size_t>(a.material)].elasticity;
  const Elasticity two = *scene.materials[static_cast<std::size_t>(b.material)].elasticity;
  const auto normal_compliance = [](const Elasticity& e) {
    return (1.0 - e.poisson_ratio * e.poisson_ratio) / e.youngs_modulus;
  };
  const auto shear_compliance = [](const Elasticity& e) {
    return 2.0 * (2.0 - e.poisson_ratio) * (1.0 + e.poisson_ratio) / e.youngs_modulus;
  };
  const auto* history = std::get_if<HistoryFriction>(&friction);
  std::ostringstream out = peers::exact_text();
  out << "hertz/history " << 4.0 / 3.0 / (normal_compliance(one) + normal_compliance(two)) << ' '
      << 8.0 / (shear_compliance(one) + shear_compliance(two)) << " 0 0 "
      << (history ? history->coefficient : 0.0) << " 1";
  return out.str();
}

}  // namespace

std::string style_of(const Scene& scene, const AtomType& a, const AtomType& b) {
  const ContactLaws* laws = peers::laws_between(scene, a, b);
  if (!laws) return {};
  return std::holds_alternative<HertzNormal>(laws->normal) ? hertz_style(scene, a, b, laws->friction)
                                                           : linear_style(scene, a, b);
}

}  // namespace grainproof::lammps
