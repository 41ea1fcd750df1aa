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

/// Dashpot given as a share γ of the critical one: 2 γ sqrt(m k), with the contact's k of the moment.
struct DampingRatio {
  double value;
};

using Dissipation = std::variant<Restitution, Damping, DampingRatio>;

/// docs/laws/linear.md. Stiffness in N/m.
struct LinearNormal {
  double stiffness;
  Dissipation dissipation;
  bool no_tension = false;  ///< clamp: the normal force never pulls
};

/// docs/laws/hertz.md. The moduli are the materials' own (Material::elasticity).
struct HertzNormal {
  Dissipation dissipation;  ///< Restitution (Tsuji's dashpot), or DampingRatio (Bilock 4.4, 4.6)
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

/// Static displacement |u_t| π sqrt(m/k_e) (Andrews 2.2).
struct CollisionTimeFriction {
  double coefficient;
  double stiffness;
};

/// As CollisionTimeFriction, plus the normal dashpot's η u_t (Andrews 2.3).
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

/// What a tangential spring keeps while the stiffness of its contact changes. The same for a linear contact.
enum class SpringMemory {
  displacement,  ///< ζ; the force is k_t of the moment times ζ (LIGGGHTS, LAMMPS gran/hertz/history)
  force,  ///< k_t ζ while k_t grows, ζ while it falls (Bilock 4.8-4.10; LAMMPS mindlin_rescale/force)
};

/// docs/laws/history.md. A tangential spring that lives as long as its contact.
struct HistoryFriction {
  double coefficient;
  double stiffness;      ///< k_t in N/m; not used with HertzNormal, whose k_t is Mindlin's
  double damping_ratio;  ///< η_t/η_n; with HertzNormal the same factor on Mindlin's dashpot
  CoulombLimit limit = CoulombLimit::spring_and_dashpot;
  TorqueArm arm = TorqueArm::radius;
  SpringTurn turn = SpringTurn::project;
  SpringMemory memory = SpringMemory::displacement;
};

using FrictionLaw = std::variant<Frictionless, DynamicFriction, StepFriction, CollisionTimeFriction,
                                 DampedFriction, HistoryFriction>;

struct NoCohesion {};

/// docs/laws/cohesion.md. Attraction k_c δ_e between effect surfaces; stiffness in N/m.
struct LinearCohesion {
  double stiffness;
};

using CohesionLaw = std::variant<NoCohesion, LinearCohesion>;

struct NoRolling {};

/// docs/laws/rolling.md. Constant directional torque: coefficient times effective radius times the elastic
/// normal force, against the relative spin (LIGGGHTS cdt).
struct ConstantTorqueRolling {
  double coefficient;
};

/// docs/laws/rolling.md. Elastic-plastic rolling spring of stiffness k_t R*², without dashpot, limited by
/// coefficient times effective radius times the normal force (LIGGGHTS epsd2). Needs HistoryFriction for k_t.
struct SpringRolling {
  double coefficient;
};

using RollingLaw = std::variant<NoRolling, ConstantTorqueRolling, SpringRolling>;

/// Everything that acts between one pair of materials.
struct ContactLaws {
  NormalLaw normal;
  FrictionLaw friction = Frictionless{};
  CohesionLaw cohesion = NoCohesion{};
  RollingLaw rolling = NoRolling{};
};

/// One visitor out of several lambdas, for std::visit over the variants above.
template <class... Alternatives>
struct Overloaded : Alternatives... {
  using Alternatives::operator()...;
};

}  // namespace grainproof
