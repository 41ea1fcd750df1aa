// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include "analytic/contact_scales.hpp"
#include "analytic/crowd_limit.hpp"
#include "analytic/hertz.hpp"
#include "analytic/possible_contacts.hpp"
#include "analytic/schemes.hpp"

namespace grainproof::analytic {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// The reason is put into words at the end, for one limit of all: a sweep has thousands.
struct Smallest {
  double step = no_limit;
  std::function<std::string()> because = [] { return "nothing limits the step"; };

  template <class Because>
  void keep(double other, Because reason) {
    if (!(other < step)) return;
    step = other;
    because = reason;
  }
};

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

double heaviest_body(const Scene& scene) {
  double heaviest = 0.0;
  for (const Particle& particle : scene.particles)
    heaviest = std::max(heaviest, particle.fixed ? no_limit
                                                 : sphere_mass(scene.materials[particle.material].density,
                                                               particle.diameter));
  return heaviest;
}

/// A restitution asks for a dashpot that grows with the root of the effective mass.
double crowded_damping(const PossibleContact& contact, double heaviest) {
  const auto* linear = std::get_if<LinearNormal>(&contact.laws->normal);
  if (contact.on_wall || (linear && std::holds_alternative<Damping>(linear->dissipation))) return 1.0;
  const double lightest = std::min(contact.masses.first, contact.masses.second);
  return std::sqrt(effective_mass(lightest, heaviest) / contact.mass);
}

/// Mass that the heaviest partner present makes of a contact.
double crowded_mass(const PossibleContact& contact, double heaviest) {
  if (contact.on_wall) return contact.mass;
  return effective_mass(std::min(contact.masses.first, contact.masses.second), heaviest);
}

/// The static branches that refer to a normal stiffness have the linear law's.
LinearNormal linear_normal(const ContactLoad& load) {
  const auto* linear = std::get_if<LinearNormal>(&load.contact.laws->normal);
  return linear ? *linear : LinearNormal{load.scale.stiffness, Damping{load.scale.damping}};
}

/// c of friction.2 where the step has no part in it; 0 for all other friction.
double creep_rate(double mass, const LinearNormal& normal, const FrictionLaw& friction) {
  const double impact_time = boost::math::constants::pi<double>() * std::sqrt(mass / normal.stiffness);
  if (const auto* law = std::get_if<CollisionTimeFriction>(&friction)) return law->stiffness * impact_time;
  if (const auto* law = std::get_if<DampedFriction>(&friction))
    return law->stiffness * impact_time + damping(normal, mass);
  return 0.0;
}

ContactLoad load_of(const Scene& scene, const PossibleContact& contact, const ClosingSpeeds& speeds,
                    double heaviest) {
  ContactLoad load{.contact = contact, .scale = scale_of(scene, contact, speeds)};
  load.crowded_damping = std::max(1.0, crowded_damping(contact, heaviest));
  load.turning = turning_of(scene, *contact.laws);
  if (scene.rotation) load.spin = std::holds_alternative<SpringRolling>(contact.laws->rolling) ? 5.0 : 2.5;
  if (const auto* step = std::get_if<StepFriction>(&contact.laws->friction))
    load.creep_stiffness = step->stiffness;
  load.creep_damping =
      creep_rate(crowded_mass(contact, heaviest), linear_normal(load), contact.laws->friction);
  const auto* friction = std::get_if<HistoryFriction>(&contact.laws->friction);
  if (!friction) return load;
  load.tangential_stiffness = friction->stiffness;
  load.tangential_damping = friction->damping_ratio * load.scale.damping;
  if (const auto* hertz = std::get_if<HertzNormal>(&contact.laws->normal)) {
    const HertzPair pair = hertz_pair(scene, contact.materials, contact.mass, contact.radius, *hertz);
    load.tangential_stiffness = pair.tangential_stiffness(load.scale.peak_overlap);
    load.tangential_damping = friction->damping_ratio * pair.damping(load.tangential_stiffness);
  }
  return load;
}

/// A tangential spring of one contact that lasts (history.8), or friction without memory.
double friction_limit(const Scene& scene, const ContactLoad& load, double drag) {
  const PossibleContact& contact = load.contact;
  if (std::holds_alternative<HistoryFriction>(contact.laws->friction))
    return pair_limit(
        linear_scheme(scene.run.integrator),
        {contact.mass / load.turning, 0.0, load.tangential_stiffness, load.tangential_damping, drag});
  return creep_limit(scene.run.integrator, contact.mass, linear_normal(load), contact.laws->friction, drag,
                     load.turning);
}

/// Every condition is monotonic in the drag rate, so the two partners' rates bracket the pair's.
void limit_by_contact(const Scene& scene, const ContactLoad& load, Smallest& limit) {
  const ContactScale& scale = load.scale;
  for (const double drag : {load.contact.slowest_drag, load.contact.fastest_drag}) {
    limit.keep(
        pair_stability_limit(scene.run.integrator, load.contact.mass, scale.stiffness, scale.damping, drag),
        [&scene, &load] {
          return "normal contact of " + described(load.scale) + " under " +
                 std::string(name_of(scene.run.integrator));
        });
    limit.keep(friction_limit(scene, load, drag), [&load] {
      return "friction of " + described(load.scale) +
             ": above it the contact chatters where it should come to rest";
    });
    if (load.contact.slowest_drag == load.contact.fastest_drag) break;
  }
}

}  // namespace

double pair_stability_limit(Integrator integrator, double mass, double stiffness, double damping,
                            double drag_rate) {
  return pair_limit(linear_scheme(integrator), {mass, stiffness, 0.0, damping, drag_rate});
}

double creep_limit(Integrator integrator, double mass, const LinearNormal& normal,
                   const FrictionLaw& friction, double drag_rate, double turning) {
  const auto lasting = [&](const auto& law) {
    return pair_stability_limit(integrator, mass, 0.0, turning * creep_rate(mass, normal, law), drag_rate);
  };
  const double drag = integrator == Integrator::euler_trapezoid_implicit_drag ? -drag_rate : drag_rate;
  return std::visit(
      Overloaded{
          [](const Frictionless&) { return no_limit; },
          [](const DynamicFriction&) { return no_limit; },
          // G (k_f h² + (m/τ) h) < 4 m, with G of stability.3: the law itself holds the step.
          [&](const StepFriction& law) {
            if (linear_scheme(integrator).weakens == Weakening::by_itself)
              return std::cbrt(4.0 * mass / (turning * law.stiffness * drag_rate));
            const double g = linear_scheme(integrator).flip.damping, slowed = g * mass * drag;
            return 8.0 * mass /
                   (slowed + std::sqrt(slowed * slowed + 16.0 * g * turning * law.stiffness * mass));
          },
          [&](const CollisionTimeFriction& law) { return lasting(law); },
          [&](const DampedFriction& law) { return lasting(law); },
          [](const HistoryFriction&) { return no_limit; },
      },
      friction);
}

StepLimit stability_limit(const Scene& scene, std::optional<double> impact_speed) {
  const Integrator integrator = scene.run.integrator;
  Smallest limit;
  const ClosingSpeeds speeds(scene, impact_speed);
  const double heaviest = heaviest_body(scene);
  std::vector<ContactLoad> loads;
  for (const PossibleContact& contact : possible_contacts(scene))
    loads.push_back(load_of(scene, contact, speeds, heaviest));
  for (const ContactLoad& load : loads) limit_by_contact(scene, load, limit);
  const StepLimit crowded = crowd_limit(scene, loads);
  limit.keep(crowded.step, [&] { return crowded.because; });
  for (const Particle& particle : scene.particles) {
    if (particle.fixed) continue;
    const double rate = drag_rate(scene.flow, scene.materials[particle.material].density, particle.diameter);
    limit.keep(pair_stability_limit(integrator, 1.0, 0.0, 0.0, rate),
               [&particle] { return "drag on particle " + std::to_string(particle.id); });
  }
  return {limit.step, limit.because()};
}

}  // namespace grainproof::analytic
