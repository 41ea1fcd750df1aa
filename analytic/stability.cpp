// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "analytic/contact_scales.hpp"
#include "analytic/possible_contacts.hpp"

/// Jury conditions of the update matrices in docs/laws/integrators.md.
namespace grainproof::analytic {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

double quotient_or_no_limit(double numerator, double denominator) {
  return denominator > 0.0 ? numerator / denominator : no_limit;
}

/// Determinant below one, and both eigenvalues above −1 (integrators.7). Implicit drag takes its rate
/// off the second condition, explicit drag adds it (integrators.9).
double trapezoid_limit(double mass, double stiffness, double damping, double drag, bool implicit_drag) {
  const double growth = quotient_or_no_limit(2.0 * (damping + mass * drag), stiffness);
  const double explicit_rate = damping + (implicit_drag ? -mass * drag : mass * drag);
  return std::min(growth, quotient_or_no_limit(2.0 * mass, explicit_rate));
}

/// k h² + 2 η h < 4 m (integrators.8).
double verlet_limit(double mass, double stiffness, double damping) {
  return quotient_or_no_limit(4.0 * mass, damping + std::sqrt(damping * damping + 4.0 * stiffness * mass));
}

void keep_smaller(StepLimit& limit, double step, const std::string& because) {
  if (step < limit.step) limit = {step, because};
}

std::string described(const PossibleContact& contact, const LinearNormal& normal, double eta) {
  std::ostringstream text;
  text.precision(6);
  text << contact.between << " (effective mass " << contact.mass << " kg, stiffness " << normal.stiffness
       << " N/m, damping " << eta << " N s/m)";
  return text.str();
}

/// Every condition is monotonic in the drag rate, so the two partners' rates bracket the pair's.
void limit_by_contact(Integrator integrator, const PossibleContact& contact, StepLimit& limit) {
  const auto& normal = std::get<LinearNormal>(contact.laws->normal);
  const double eta = damping(normal, contact.mass);
  const std::string pair = described(contact, normal, eta);
  for (const double drag : {contact.slowest_drag, contact.fastest_drag}) {
    keep_smaller(limit, pair_stability_limit(integrator, contact.mass, normal.stiffness, eta, drag),
                 "normal contact of " + pair + " under " + std::string(name_of(integrator)));
    keep_smaller(limit, creep_limit(integrator, contact.mass, normal, contact.laws->friction, drag),
                 "friction of " + pair + ": above it the contact chatters where it should creep to rest");
  }
}

}  // namespace

double pair_stability_limit(Integrator integrator, double mass, double stiffness, double damping,
                            double drag_rate) {
  switch (integrator) {
    case Integrator::euler_trapezoid:
      return trapezoid_limit(mass, stiffness, damping, drag_rate, false);
    case Integrator::euler_trapezoid_implicit_drag:
      return trapezoid_limit(mass, stiffness, damping, drag_rate, true);
    case Integrator::leapfrog_verlet:
    case Integrator::velocity_verlet:
      return verlet_limit(mass, stiffness, damping + mass * drag_rate);
  }
  return 0.0;
}

double creep_limit(Integrator integrator, double mass, const LinearNormal& normal,
                   const FrictionLaw& friction, double drag_rate) {
  const double impact_time = boost::math::constants::pi<double>() * std::sqrt(mass / normal.stiffness);
  const auto limit_of = [&](double rate) {
    return pair_stability_limit(integrator, mass, 0.0, rate, drag_rate);
  };
  const double drag = integrator == Integrator::euler_trapezoid_implicit_drag ? -drag_rate : drag_rate;
  return std::visit(
      Overloaded{
          [](const Frictionless&) { return no_limit; },
          [](const DynamicFriction&) { return no_limit; },
          // k_f h² + (m/τ) h < 2 m: the law itself holds the step.
          [&](const StepFriction& law) {
            return 4.0 * mass /
                   (mass * drag + std::sqrt(std::pow(mass * drag, 2) + 8.0 * law.stiffness * mass));
          },
          [&](const CollisionTimeFriction& law) { return limit_of(law.stiffness * impact_time); },
          [&](const DampedFriction& law) {
            return limit_of(law.stiffness * impact_time + damping(normal, mass));
          },
      },
      friction);
}

StepLimit stability_limit(const Scene& scene) {
  const Integrator integrator = scene.run.integrator;
  StepLimit limit{no_limit, "nothing limits the step"};
  for (const PossibleContact& contact : possible_contacts(scene))
    limit_by_contact(integrator, contact, limit);
  for (const Particle& particle : scene.particles) {
    if (particle.fixed) continue;
    const double rate = drag_rate(scene.flow, scene.materials[particle.material].density, particle.diameter);
    const double step = pair_stability_limit(integrator, 1.0, 0.0, 0.0, rate);
    if (step < limit.step) limit = {step, "drag on particle " + std::to_string(particle.id)};
  }
  return limit;
}

}  // namespace grainproof::analytic
