// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "model/vec3.hpp"

namespace grainproof {

/// What a law remembers of one contact, keyed by who touches whom and never by an index.
struct ContactMemory {
  std::int64_t first;                  ///< particle id
  std::int64_t second;                 ///< particle id, or −1 − index for a wall
  std::int32_t feature;                ///< face, edge or corner of the second; 0 for a sphere or a plane
  Vec3 tangential_displacement;        ///< m
  double overlap = 0.0;                ///< m, at the last force; kept by SpringMemory::force
  Vec3 rolling_torque = Vec3::Zero();  ///< N m, of the rolling spring; kept by SpringRolling
};

/// What a run is made of at a step boundary: enough to go on from here.
struct State {
  std::int64_t step = 0;
  double time = 0.0;                    ///< s
  std::vector<std::int64_t> ids;        ///< increasing; the order of all arrays below
  std::vector<Vec3> position;           ///< m
  std::vector<Vec3> velocity;           ///< m/s, as the integrator holds it
  std::vector<Vec3> angular_velocity;   ///< rad/s, held like `velocity`; empty without rotation
  std::vector<Quaternion> orientation;  ///< from body to scene; empty unless Scene::orientation asks for it
  double velocity_lag = 0.0;            ///< steps by which `velocity` is behind `time` (leap-frog: 1/2)
  std::vector<ContactMemory> contacts;
};

}  // namespace grainproof
