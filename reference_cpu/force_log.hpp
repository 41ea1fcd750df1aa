// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "model/sections.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/contact_force.hpp"
#include "reference_cpu/encounter.hpp"

/// What the forces at one moment mean for energy and momentum. Written while they are summed, and
/// only for runs with a ledger: NoLog compiles to nothing.
namespace grainproof::reference {

struct NoLog {
  void contact(const PairLaws&, const Encounter&, const TorqueArms&, const ContactPoint&, const ContactForce&,
               const ContactSprings&) {}
  void rolling(const Encounter&, const Vec3&, const Vec3&) {}
  void attraction(const PairLaws&, double) {}
  void pair_force(const Bodies&, std::int32_t, std::int32_t, const Vec3&) {}
  void wall_force(const Encounter&, const Vec3&, const Vec3&) {}
};

/// Contact forces that take energy out, on body 2.
struct LoggedContact {
  Encounter meet;
  TorqueArms arms;
  Vec3 dashpot;
  Vec3 friction;
};

struct LoggedRolling {
  Encounter meet;
  Vec3 torque;     ///< on body 2, N m
  Vec3 wall_spin;  ///< rad/s; zero between particles
};

/// What a wall does to all particles.
struct WallAction {
  Vec3 force = Vec3::Zero();   ///< N
  Vec3 moment = Vec3::Zero();  ///< about the wall's reference point, N m
};

struct ForceLog {
  explicit ForceLog(const Scene& scene) : walls(scene.walls.size()) {}

  void clear();
  void contact(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms, const ContactPoint& point,
               const ContactForce& force, const ContactSprings& springs);
  /// `spin_one` is that of body 1.
  void rolling(const Encounter& meet, const Vec3& on_second, const Vec3& spin_one);
  void attraction(const PairLaws& laws, double effect_overlap);
  void pair_force(const Bodies& bodies, std::int32_t first, std::int32_t second, const Vec3& on_second);
  /// `arm` points from the wall's reference point to where the force acts.
  void wall_force(const Encounter& meet, const Vec3& on_particle, const Vec3& arm);

  void pack_into(Sections& own) const;
  void unpack_from(const Sections& own);

  double elastic = 0.0;         ///< in normal springs, J
  double tangential = 0.0;      ///< in tangential springs, J
  double wound = 0.0;           ///< in rolling springs, J
  double cohesive = 0.0;        ///< J
  double wall_power = 0.0;      ///< of moving walls on particles, W
  Vec3 support = Vec3::Zero();  ///< N, from walls and fixed particles on moving ones
  std::vector<WallAction> walls;
  std::vector<LoggedContact> contacts;
  std::vector<LoggedRolling> rollings;
  std::vector<Vec3> gravity;  ///< N, per particle; zero for fixed ones
  std::vector<Vec3> drag;     ///< N, per particle; empty without flow or where the integrator applies it
  std::vector<Vec3> fluid;    ///< m/s at each particle; filled only where the integrator applies drag
};

}  // namespace grainproof::reference
