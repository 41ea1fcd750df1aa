// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>

#include "model/vec3.hpp"

namespace grainproof::reference {

/// Two surfaces near each other, body 2 seen from body 1.
struct Encounter {
  std::int32_t first;   ///< particle, or −1 − index of a wall
  std::int32_t second;  ///< particle
  Vec3 normal;
  double overlap;                     ///< of the bodies, m
  double effect_overlap;              ///< of the reaches of cohesion, m
  Vec3 wall_velocity = Vec3::Zero();  ///< of the surface, where body 1 is a wall, m/s

  bool with_wall() const { return first < 0; }
};

inline std::int32_t wall_as_body(std::size_t wall) {
  return -1 - static_cast<std::int32_t>(wall);
}

inline std::size_t wall_of(const Encounter& meet) {
  return static_cast<std::size_t>(-1 - meet.first);
}

/// From the centres to where friction acts, m; zero where nothing turns.
struct TorqueArms {
  double first = 0.0;
  double second = 0.0;
};

}  // namespace grainproof::reference
