// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <optional>

#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof {

/// Two bodies that may touch: `second` is a moving particle, the other a particle or a wall.
/// The normal points to `second`.
struct Pair {
  std::size_t second = 0;
  std::optional<std::size_t> first;  ///< index of a particle; without it the partner is `wall`
  std::size_t wall = 0;
};

/// From one point to the nearest image of another.
Vec3 separation(const Domain& domain, const Vec3& from, const Vec3& to);

enum class Surface { body, effect };

/// Of unit length, to `second`; from the nearest image of the other, or from the surface of the wall.
Vec3 normal(const Scene& scene, const Frame& frame, const Pair& pair);

/// Distance between the surfaces, negative when they overlap. A wall's effect reach is zero.
double gap(const Scene& scene, const Frame& frame, const Pair& pair, Surface surface = Surface::body);

/// Velocity of `second` seen from the other; a fixed particle does not move.
Vec3 relative_velocity(const Scene& scene, const Frame& frame, const Pair& pair);

/// Velocity of `second`'s point at distance r towards the other, seen from the other's such point: with
/// rotation v2 − v1 − (r2 ω2 + r1 ω1) × n.
Vec3 contact_velocity(const Scene& scene, const Frame& frame, const Pair& pair, const Vec3& normal);

/// Time until the surfaces touch if both go on in a straight line; negative looks back with
/// `direction` −1. Empty if they never do.
std::optional<double> time_to_touch(const Scene& scene, const Frame& frame, const Pair& pair,
                                    Surface surface = Surface::body, double direction = 1.0);

/// The pair that touches first in straight flight, or the deepest of those that already overlap.
/// Empty if none will. Looks at every pair, so for scenes of few particles.
std::optional<Pair> first_contact(const Scene& scene, const Frame& frame, Surface surface = Surface::body);

/// The pair with the deepest overlap, or the smallest gap where none overlaps.
std::optional<Pair> deepest_contact(const Scene& scene, const Frame& frame);

}  // namespace grainproof
