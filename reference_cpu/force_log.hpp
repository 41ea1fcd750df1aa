// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "reference_cpu/bodies.hpp"
#include "reference_cpu/contact_force.hpp"
#include "reference_cpu/encounter.hpp"

/// What the forces at one moment mean for energy and momentum. Written while they are summed, and
/// only for runs with a ledger: NoLog compiles to nothing.
namespace grainproof::reference {

struct NoLog {
  void contact(const PairLaws&, const Encounter&, const TorqueArms&, const ContactPoint&, const ContactForce&,
               const Vec3&) {}
  void attraction(const PairLaws&, double) {}
  void pair_force(const Bodies&, std::int32_t, std::int32_t, const Vec3&) {}
  void wall_force(std::size_t, const Vec3&) {}
};

/// Contact forces that take energy out, on body 2.
struct LoggedContact {
  Encounter meet;
  TorqueArms arms;
  Vec3 dashpot;
  Vec3 friction;
};

struct ForceLog {
  explicit ForceLog(const Scene& scene) : wall_force_on_particles(scene.walls.size(), Vec3::Zero()) {}

  void clear();
  void contact(const PairLaws& laws, const Encounter& meet, const TorqueArms& arms, const ContactPoint& point,
               const ContactForce& force, const Vec3& displacement);
  void attraction(const PairLaws& laws, double effect_overlap);
  void pair_force(const Bodies& bodies, std::int32_t first, std::int32_t second, const Vec3& on_second);
  void wall_force(std::size_t wall, const Vec3& on_particle);

  double elastic = 0.0;                       ///< in normal springs, J
  double tangential = 0.0;                    ///< in tangential springs, J
  double cohesive = 0.0;                      ///< J
  Vec3 support = Vec3::Zero();                ///< N, from walls and fixed particles on moving ones
  std::vector<Vec3> wall_force_on_particles;  ///< N
  std::vector<LoggedContact> contacts;
  std::vector<Vec3> gravity;  ///< N, per particle; zero for fixed ones
  std::vector<Vec3> drag;     ///< N, per particle; empty without flow or where the integrator applies it
  std::vector<Vec3> fluid;    ///< m/s at each particle; filled only where the integrator applies drag
};

}  // namespace grainproof::reference
