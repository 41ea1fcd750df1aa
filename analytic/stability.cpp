// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "analytic/contact_scales.hpp"
#include "analytic/hertz.hpp"
#include "analytic/possible_contacts.hpp"

/// Jury conditions of the update matrices in docs/laws/integrators.md.
namespace grainproof::analytic {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

double quotient_or_no_limit(double numerator, double denominator) {
  return denominator > 0.0 ? numerator / denominator : no_limit;
}

// Velocities change sign at each step at the limit: k h²/4 + c h = m.
double predicted_limit(double mass, double stiffness, double damping) {
  if (stiffness == 0.0) return mass / damping;
  return 2.0 * (std::sqrt(damping * damping + mass * stiffness) - damping) / stiffness;
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

std::string described(const ContactScale& scale) {
  std::ostringstream text;
  text.precision(6);
  text << scale.between << " (effective mass " << scale.effective_mass << " kg, stiffness " << scale.stiffness
       << " N/m, damping " << scale.damping << " N s/m";
  if (scale.peak_overlap > 0.0) text << " at its deepest overlap of " << scale.peak_overlap << " m";
  text << ")";
  return text.str();
}

/// A force at the point of contact of two spheres moves that point by 1/m + r²/I of each (rotation.4); a
/// spring against rolling stiffens the quickest motion of both (rolling.9).
double turning_of(const Scene& scene, const ContactLaws& laws) {
  if (!scene.rotation) return 1.0;
  return std::holds_alternative<SpringRolling>(laws.rolling) ? 3.0 + std::sqrt(6.5) : 3.5;
}

/// The tangential spring of a lasting contact (history.8).
double spring_limit(const Scene& scene, const PossibleContact& contact, const ContactScale& scale,
                    const HistoryFriction& friction, double drag) {
  double stiffness = friction.stiffness, eta = friction.damping_ratio * scale.damping;
  if (const auto* hertz = std::get_if<HertzNormal>(&contact.laws->normal)) {
    const HertzPair pair = hertz_pair(scene, contact.materials, contact.mass, contact.radius, *hertz);
    stiffness = pair.tangential_stiffness(scale.peak_overlap);
    eta = friction.damping_ratio * pair.damping(stiffness);
  }
  return pair_stability_limit(scene.run.integrator, contact.mass / turning_of(scene, *contact.laws),
                              stiffness, eta, drag);
}

double friction_limit(const Scene& scene, const PossibleContact& contact, const ContactScale& scale,
                      double drag) {
  if (const auto* history = std::get_if<HistoryFriction>(&contact.laws->friction))
    return spring_limit(scene, contact, scale, *history, drag);
  // The static branches that refer to a normal stiffness have the linear law's.
  const auto* linear = std::get_if<LinearNormal>(&contact.laws->normal);
  return creep_limit(scene.run.integrator, contact.mass,
                     linear ? *linear : LinearNormal{scale.stiffness, Damping{scale.damping}},
                     contact.laws->friction, drag, turning_of(scene, *contact.laws));
}

/// Every condition is monotonic in the drag rate, so the two partners' rates bracket the pair's.
void limit_by_contact(const Scene& scene, const PossibleContact& contact, const ClosingSpeeds& speeds,
                      StepLimit& limit) {
  const Integrator integrator = scene.run.integrator;
  const ContactScale scale = scale_of(scene, contact, speeds);
  const std::string pair = described(scale);
  for (const double drag : {contact.slowest_drag, contact.fastest_drag}) {
    keep_smaller(limit, pair_stability_limit(integrator, contact.mass, scale.stiffness, scale.damping, drag),
                 "normal contact of " + pair + " under " + std::string(name_of(integrator)));
    keep_smaller(limit, friction_limit(scene, contact, scale, drag),
                 "friction of " + pair + ": above it the contact chatters where it should come to rest");
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
    // Refining the dashpot's velocity only widens the limit.
    case Integrator::velocity_verlet_predicted:
    case Integrator::onset_corrected:
      return predicted_limit(mass, stiffness, damping + mass * drag_rate);
  }
  return 0.0;
}

double creep_limit(Integrator integrator, double mass, const LinearNormal& normal,
                   const FrictionLaw& friction, double drag_rate, double turning) {
  const double impact_time = boost::math::constants::pi<double>() * std::sqrt(mass / normal.stiffness);
  const auto limit_of = [&](double rate) {
    return pair_stability_limit(integrator, mass, 0.0, turning * rate, drag_rate);
  };
  const double drag = integrator == Integrator::euler_trapezoid_implicit_drag ? -drag_rate : drag_rate;
  return std::visit(
      Overloaded{
          [](const Frictionless&) { return no_limit; },
          [](const DynamicFriction&) { return no_limit; },
          // k_f h² + (m/τ) h < 2 m: the law itself holds the step.
          [&](const StepFriction& law) {
            return 4.0 * mass /
                   (mass * drag + std::sqrt(std::pow(mass * drag, 2) + 8.0 * turning * law.stiffness * mass));
          },
          [&](const CollisionTimeFriction& law) { return limit_of(law.stiffness * impact_time); },
          [&](const DampedFriction& law) {
            return limit_of(law.stiffness * impact_time + damping(normal, mass));
          },
          [](const HistoryFriction&) { return no_limit; },
      },
      friction);
}

StepLimit stability_limit(const Scene& scene, std::optional<double> impact_speed) {
  const Integrator integrator = scene.run.integrator;
  StepLimit limit{no_limit, "nothing limits the step"};
  const ClosingSpeeds speeds(scene, impact_speed);
  for (const PossibleContact& contact : possible_contacts(scene))
    limit_by_contact(scene, contact, speeds, limit);
  for (const Particle& particle : scene.particles) {
    if (particle.fixed) continue;
    const double rate = drag_rate(scene.flow, scene.materials[particle.material].density, particle.diameter);
    const double step = pair_stability_limit(integrator, 1.0, 0.0, 0.0, rate);
    if (step < limit.step) limit = {step, "drag on particle " + std::to_string(particle.id)};
  }
  return limit;
}

}  // namespace grainproof::analytic
