// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "model/laws.hpp"
#include "model/scene.hpp"

/// What a contact's parameters say before anything runs: masses, dashpots, durations, step limits.
/// Equations in docs/laws/linear.md, hertz.md and integrators.md. SI throughout.
namespace grainproof::analytic {

/// ρ π d³/6.
double sphere_mass(double density, double diameter);

/// m1 m2/(m1 + m2); an infinite mass (fixed particle, wall) leaves the other.
double effective_mass(double mass_1, double mass_2);

/// η in N s/m (linear.3, linear.9). Throws InputRefused for a restitution outside [0, 1] and for
/// restitution 0 with `no_tension`, which no finite dashpot reaches.
double damping(const LinearNormal& law, double mass);

/// Rebound of a contact whose dashpot may pull (linear.5); 0 where critically or over-damped.
double restitution_of(double damping, double stiffness, double mass);

/// Rebound of a contact that ends when its force falls to zero (linear.8). Schwager & Pöschel 2007.
double no_tension_restitution_of(double damping, double stiffness, double mass);

/// Time scale of a contact (linear.6): π/ω_d, or π sqrt(m/k) where critically or over-damped.
double contact_duration(double stiffness, double damping, double mass);

/// The shortest time scale of a scene and the pair that has it.
struct ContactScale {
  double duration;        ///< s
  double effective_mass;  ///< kg
  double stiffness;       ///< N/m; of a Hertz contact at its deepest
  double damping;         ///< N s/m; likewise
  double peak_overlap;    ///< m, that a Hertz contact's numbers are taken at; 0 with the linear law
  std::string between;    ///< "glass and glass", "glass and wall floor"
};

/// How fast bodies can meet, m/s: the sum of the two largest speeds at the start for two particles, the
/// largest and the fastest wall's for a particle and a wall; `impact_speed` for both where it is given.
struct ClosingSpeeds {
  double of_pairs;
  double on_walls;

  explicit ClosingSpeeds(const Scene& scene, std::optional<double> impact_speed = std::nullopt);
};

/// Smallest duration over the lightest pair of every two materials present and over the lightest sphere
/// against every wall; none where nothing can touch. A Hertz contact's is that of an elastic impact at
/// the closing speed (hertz.11): infinite where nothing moves.
std::optional<ContactScale> shortest_contact(const Scene& scene, std::optional<double> impact_speed = {});

/// Whether a Hertz contact is possible, whose time scale depends on a speed, and nothing moves.
bool lacks_impact_speed(const Scene& scene);

/// A step must stay below `step`; infinity where nothing limits it.
struct StepLimit {
  double step;          ///< s
  std::string because;  ///< which contact or particle, and which condition
};

/// Largest stable step of one sustained linear contact in closed form, with drag of rate 1/τ on it
/// (integrators.7 to 9). 0: unstable at every step. Infinity: stable at every step. Stiffness 0 leaves drag
/// alone.
double pair_stability_limit(Integrator integrator, double mass, double stiffness, double damping,
                            double drag_rate = 0.0);

/// Largest step at which static friction creeps to rest rather than chatters at the Coulomb limit
/// (integrators.10); infinity for laws without a static branch. `turning` says by how much more a force
/// moves the point of contact than the centre: 7/2 where spheres turn, else 1 (rotation.4).
double creep_limit(Integrator integrator, double mass, const LinearNormal& normal,
                   const FrictionLaw& friction, double drag_rate = 0.0, double turning = 1.0);

/// The smallest limit over the pairs of `shortest_contact`, their friction, drag, and bodies with as many
/// contacts at once as the scene has room for (analytic/crowd.hpp): what holds for them holds for every
/// arrangement. A Hertz contact counts with its stiffness and dashpot at the deepest overlap (hertz.13), a
/// tangential spring likewise (history.8).
StepLimit stability_limit(const Scene& scene, std::optional<double> impact_speed = {});

}  // namespace grainproof::analytic
