// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/pair_laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/errors.hpp"

namespace grainproof::opencl {
namespace {

using std::numbers::pi;

/// Rebound of a contact that ends when k δ + η δ' = 0: exp(−2ζ arccos ζ/sqrt(1 − ζ²)), continued beyond ζ
/// = 1.
double restitution_without_tension(double ratio) {
  if (ratio == 1.0) return std::exp(-2.0);
  const double root = std::sqrt(std::abs(1.0 - ratio * ratio));
  const double angle = ratio < 1.0 ? std::acos(ratio) : std::acosh(ratio);
  return std::exp(-2.0 * ratio * angle / root);
}

struct DampingOf {
  double stiffness;
  bool no_tension;

  MassLaw operator()(const Damping& given) const { return {given.value, 0.0}; }

  MassLaw operator()(const DampingRatio& share) const {
    return {0.0, 2.0 * share.value * std::sqrt(stiffness)};
  }

  MassLaw operator()(const Restitution& wanted) const {
    if (no_tension) return {0.0, 2.0 * damping_ratio_without_tension(wanted.value) * std::sqrt(stiffness)};
    if (wanted.value == 0.0) return {0.0, 2.0 * std::sqrt(stiffness)};
    const double log_e = std::log(wanted.value);
    return {0.0, -2.0 * log_e * std::sqrt(stiffness / (pi * pi + log_e * log_e))};
  }
};

struct FrictionInto {
  PairCoefficients& c;
  double step;
  double shear_modulus;  ///< G*, of a Hertz contact only

  void operator()(const Frictionless&) const {}
  void operator()(const DynamicFriction& law) const {
    c.friction = law.coefficient;
    c.unlimited = true;
  }
  void operator()(const StepFriction& law) const {
    c.friction = law.coefficient;
    c.viscosity.constant = law.stiffness * step;
  }
  void operator()(const CollisionTimeFriction& law) const {
    if (c.hertz) throw InputRefused("a Hertz contact has no one collision time for its friction");
    c.friction = law.coefficient;
    c.viscosity.per_root_mass = law.stiffness * pi / std::sqrt(c.stiffness);
  }
  void operator()(const DampedFriction& law) const {
    (*this)(CollisionTimeFriction{law.coefficient, law.stiffness});
    c.viscosity.constant += c.damping.constant;
    c.viscosity.per_root_mass += c.damping.per_root_mass;
  }
  /// A Hertz contact's dashpot grows with the root of its stiffness, and k_t/k_n is the same at any overlap.
  void operator()(const HistoryFriction& law) const {
    const double k = c.hertz ? 8.0 * shear_modulus : law.stiffness;
    if (!(k > 0.0)) throw InputRefused("friction with history needs a tangential stiffness above 0");
    const double normal = 1.5 * c.stiffness;  // of a Hertz contact: 2 E*
    const double ratio = law.damping_ratio * (c.hertz ? std::sqrt(k / normal) : 1.0);
    c.history = {law.coefficient, k,       {ratio * c.damping.constant, ratio * c.damping.per_root_mass},
                 law.limit,       law.arm, law.turn};
  }
};

struct CohesionInto {
  PairCoefficients& c;

  void operator()(const NoCohesion&) const {}
  void operator()(const LinearCohesion& law) const { c.cohesion = law.stiffness; }
};

}  // namespace

double MassLaw::at(double mass) const {
  return constant + per_root_mass * std::sqrt(mass);
}

double damping_ratio_without_tension(double restitution) {
  if (!(restitution > 0.0))
    throw InputRefused(
        "restitution 0 with no_tension: a contact that never pulls always rebounds; "
        "expected a restitution above 0");
  double low = 0.0, high = 1.0;
  while (restitution_without_tension(high) > restitution) high *= 2.0;
  while (true) {
    const double middle = low + (high - low) / 2.0;
    if (middle <= low || middle >= high) return middle;
    (restitution_without_tension(middle) > restitution ? low : high) = middle;
  }
}

MassLaw damping_of(const LinearNormal& law) {
  return std::visit(DampingOf{law.stiffness, law.no_tension}, law.dissipation);
}

EffectiveModuli effective_moduli(const Material& a, const Material& b) {
  double compliance = 0.0, shear_compliance = 0.0;
  for (const Material* m : {&a, &b}) {
    if (!m->elasticity) throw InputRefused("material " + m->name + " has no elasticity, which Hertz needs");
    const auto [e, nu] = *m->elasticity;
    compliance += (1.0 - nu * nu) / e;
    shear_compliance += 2.0 * (2.0 - nu) * (1.0 + nu) / e;  // (2 − ν)/G, E13
  }
  return {1.0 / compliance, 1.0 / shear_compliance};
}

PairCoefficients coefficients_of(const Scene& scene, std::size_t a, std::size_t b) {
  const ContactLaws& laws = scene.contacts.at(a, b);
  PairCoefficients c;
  double shear_modulus = 0.0;
  std::visit(Overloaded{[&](const LinearNormal& law) {
                          c.stiffness = law.stiffness;
                          c.damping = damping_of(law);
                          c.no_tension = law.no_tension;
                        },
                        [&](const HertzNormal& law) {
                          const auto moduli = effective_moduli(scene.materials[a], scene.materials[b]);
                          c.hertz = true;
                          c.stiffness = 4.0 / 3.0 * moduli.youngs;
                          c.damping = damping_of(law, moduli.youngs);
                          shear_modulus = moduli.shear;
                        }},
             laws.normal);
  std::visit(FrictionInto{c, scene.run.step, shear_modulus}, laws.friction);
  std::visit(CohesionInto{c}, laws.cohesion);
  return c;
}

// docs/laws/hertz.md: 2 β sqrt(5/6) sqrt(m k_n) or 2 γ sqrt(m k_n), k_n = 2 E* sqrt(R* δ).
MassLaw damping_of(const HertzNormal& law, double youngs_modulus) {
  if (const auto* share = std::get_if<DampingRatio>(&law.dissipation))
    return {0.0, 2.0 * share->value * std::sqrt(2.0 * youngs_modulus)};
  const auto* wanted = std::get_if<Restitution>(&law.dissipation);
  if (wanted == nullptr)
    throw InputRefused("a Hertz contact takes its dashpot from a restitution or a damping ratio");
  if (!(wanted->value > 0.0))
    throw InputRefused("restitution 0 in a Hertz contact, which then never ends; expected one above 0");
  const double log_e = std::log(wanted->value);
  const double beta = -log_e / std::hypot(log_e, pi);
  return {0.0, 2.0 * beta * std::sqrt(5.0 / 6.0 * 2.0 * youngs_modulus)};
}

double inertia_of(const Particle& particle, const Scene& scene) {
  return 0.4 * mass_of(particle, scene) * particle.diameter * particle.diameter / 4.0;
}

double mass_of(const Particle& particle, const Scene& scene) {
  const double d = particle.diameter;
  return scene.materials[static_cast<std::size_t>(particle.material)].density * pi * d * d * d / 6.0;
}

double shortest_contact(const Scene& scene) {
  double stiffest = 0.0;
  double lightest = std::numeric_limits<double>::max();
  for (std::size_t a = 0; a < scene.contacts.materials(); ++a)
    for (std::size_t b = a; b < scene.contacts.materials(); ++b)
      if (scene.contacts.has(a, b))
        if (const auto c = coefficients_of(scene, a, b); !c.hertz) stiffest = std::max(stiffest, c.stiffness);
  for (const Particle& p : scene.particles)
    if (!p.fixed) lightest = std::min(lightest, mass_of(p, scene));
  if (stiffest <= 0.0 || lightest == std::numeric_limits<double>::max()) return 0.0;
  return pi * std::sqrt(lightest / 2.0 / stiffest);
}

}  // namespace grainproof::opencl
