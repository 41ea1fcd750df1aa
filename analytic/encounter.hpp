// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "analytic/linear_motion.hpp"
#include "model/engine.hpp"

namespace grainproof::analytic {

/// A moving sphere and one partner (sphere or wall) along a fixed normal. The gap is the distance
/// between the body surfaces, positive apart; body 2 moves, body 1 may be a wall or fixed.
struct Encounter {
  std::optional<std::size_t> first;    ///< index of body 1; none for a wall
  std::size_t second = 0;              ///< index of body 2
  std::optional<Rectangle> rectangle;  ///< where the wall ends
  Vec3 normal = Vec3::Zero();          ///< from body 1 to body 2, or out of the wall
  double mass = 0.0;                   ///< effective, kg
  double touching = 0.0;               ///< distance of the centres (to the wall) at gap 0, m
  double reach = 0.0;                  ///< gap at which cohesion begins, m; 0 without cohesion
  Motion gap{0.0, 0.0};                ///< at the start
  Vec3 slip = Vec3::Zero();            ///< velocity of body 2 relative to body 1 across the normal
  double gravity = 0.0;                ///< relative acceleration along the normal, m/s²
  Vec3 gravity_across = Vec3::Zero();  ///< relative acceleration across the normal
  Vec3 centre =
      Vec3::Zero();  ///< of mass, or the immovable partner, or the foot on the wall, which it follows
  Vec3 centre_velocity = Vec3::Zero();
  Vec3 centre_acceleration = Vec3::Zero();
  double first_share = 0.0;   ///< body 1 lies at centre − share · separation
  double second_share = 1.0;  ///< body 2 lies at centre + share · separation
  ContactLaws laws;

  const LinearNormal& normal_law() const { return std::get<LinearNormal>(laws.normal); }
  double cohesion_stiffness() const;
};

/// The encounter that a scene consists of, or why it is none.
struct Recognised {
  Support support;
  Encounter encounter;
};

/// One free sphere and one wall that moves evenly or not at all (a cylinder only along its radius), or two
/// spheres of which at least one is free; no flow, constant gravity. Any laws but those of rolling, spinning
/// or not.
Recognised recognise_bodies(const Scene& scene);

/// The same with laws of rolling.
Recognised recognise_rolling(const Scene& scene);

/// The same where the linear normal law holds and nothing can make the bodies turn.
Recognised recognise(const Scene& scene);

/// Of a wall that doesn't move, or moves evenly; none where it vibrates or turns.
std::optional<Vec3> wall_velocity(const Wall& wall);

/// Whether spins move the surfaces against each other where they touch. Two equal spheres that turn
/// oppositely roll on each other, and a spin about the normal rubs nowhere.
bool spins_rub(const Scene& scene, const Encounter& encounter);

/// No velocity across the normal, to round-off of the positions that define it.
bool head_on(const Encounter& encounter);

/// Overlapping by more than the rounding of positions.
bool starts_in_contact(const Encounter& encounter);

/// Slip of body 2 relative to body 1 since the start.
struct Slip {
  Vec3 displacement;
  Vec3 velocity;
};

/// All particles where the scene has them, spinning as they do there.
Frame frame_of(const Scene& scene, double time);

/// All particles of the scene when the gap and the slip are these.
Frame frame_of(const Scene& scene, const Encounter& encounter, const Motion& gap, const Slip& slip,
               double time);

/// False when the sphere's foot has run off a rectangular wall.
bool over_wall(const Encounter& encounter, const Vec3& displacement);

}  // namespace grainproof::analytic
