// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <variant>

/// Parameters of the contact laws: what an engine is told, never how it computes.
/// The equations are in docs/laws/. A law is added by a new alternative here; std::visit
/// then makes the compiler refuse every engine that lacks it.
namespace grainproof {

/// Dashpot given by the normal coefficient of restitution, 0 … 1; each engine inverts it by itself.
struct Restitution {
  double value;
};

/// Dashpot given directly, N s/m; the only way to ask for an over-damped contact.
struct Damping {
  double value;
};

using Dissipation = std::variant<Restitution, Damping>;

/// docs/laws/linear.md. Stiffness in N/m.
struct LinearNormal {
  double stiffness;
  Dissipation dissipation;
  bool no_tension = false;  ///< clamp: the normal force never pulls
};

/// docs/laws/hertz.md. The moduli are the materials' own (Material::elasticity).
struct HertzNormal {
  Dissipation dissipation;  ///< Restitution only
};

using NormalLaw = std::variant<LinearNormal, HertzNormal>;

struct Frictionless {};

/// docs/laws/friction.md. Coulomb limit only: dynamic friction at any slip.
struct DynamicFriction {
  double coefficient;
};

/// Static displacement |u_t| Δt (Andrews 3.2); stiffness in N/m.
struct StepFriction {
  double coefficient;
  double stiffness;
};

/// Static displacement |u_t| π sqrt(m/k_e) (Andrews 2.3).
struct CollisionTimeFriction {
  double coefficient;
  double stiffness;
};

/// As CollisionTimeFriction, plus the normal dashpot's η u_t (Andrews 2.4).
struct DampedFriction {
  double coefficient;
  double stiffness;
};

/// What the Coulomb limit μ |F_n| is put on, and so what the spring is cut back to when it slides.
enum class CoulombLimit {
  spring,              ///< the spring alone; no dashpot while it slides (LIGGGHTS)
  spring_and_dashpot,  ///< their sum (LAMMPS)
};

/// Distance from a sphere's centre at which tangential forces turn it.
enum class TorqueArm {
  radius,   ///< r (LAMMPS)
  overlap,  ///< r − δ/2, a wall's whole overlap counted half as well (LIGGGHTS)
};

/// How the spring follows the tangent plane as a pair turns.
enum class SpringTurn {
  project,              ///< its part in the plane (LAMMPS gran/hooke/history, LIGGGHTS)
  project_and_rescale,  ///< the same at its former length (LAMMPS granular)
};

/// docs/laws/history.md. A tangential spring that lives as long as its contact.
struct HistoryFriction {
  double coefficient;
  double stiffness;      ///< k_t in N/m; not used with HertzNormal, whose k_t is Mindlin's
  double damping_ratio;  ///< η_t/η_n; with HertzNormal the same factor on Mindlin's dashpot
  CoulombLimit limit = CoulombLimit::spring_and_dashpot;
  TorqueArm arm = TorqueArm::radius;
  SpringTurn turn = SpringTurn::project_and_rescale;
};

using FrictionLaw = std::variant<Frictionless, DynamicFriction, StepFriction, CollisionTimeFriction,
                                 DampedFriction, HistoryFriction>;

struct NoCohesion {};

/// docs/laws/cohesion.md. Attraction k_c δ_e between effect surfaces; stiffness in N/m.
struct LinearCohesion {
  double stiffness;
};

using CohesionLaw = std::variant<NoCohesion, LinearCohesion>;

/// Everything that acts between one pair of materials.
struct ContactLaws {
  NormalLaw normal;
  FrictionLaw friction = Frictionless{};
  CohesionLaw cohesion = NoCohesion{};
};

/// One visitor out of several lambdas, for std::visit over the variants above.
template <class... Alternatives>
struct Overloaded : Alternatives... {
  using Alternatives::operator()...;
};

}  // namespace grainproof
