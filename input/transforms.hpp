// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

#include "input/sweep.hpp"

/// What a sweep does to a whole scene that has been read.
namespace grainproof::input {

using Rotation = Eigen::Matrix3d;

/// Uniform over all orientations (Shoemake 1992); no rotation at all where there is no sweep of them.
std::vector<Rotation> rotations_of(const Sweep& sweep);

/// i-th of a low-discrepancy sequence in [-1/2, 1/2): additive recurrence with the golden ratio.
double dither(int sample);

/// The same materials and speeds at `scale` times the size: lengths and times with it, masses with its cube,
/// stiffnesses as they must for the same motion. Gravity and spins are the larger, the smaller it is.
/// False where a mass, a length or another number then has none of its own.
[[nodiscard]] bool rescale(SetUp& set_up, double scale);

/// A vector in metres, or of the scene's largest diameters.
Vec3 offset_of(const Node& node, const Scene& scene);

/// Shifts particles, domain, walls and the centre of gravity.
void shift(Scene& scene, const Vec3& offset, const Node& place);

/// Turns particles, planes and fields about the middle of the domain, which stays as it is.
void rotate(Scene& scene, const Rotation& rotation, const Node& place);

/// Takes every moving particle back along its straight line by `time`.
void start_earlier(Scene& scene, double time);

/// Refuses, at the onset, a scene in which no two surfaces touch to 1e-9 of their radii.
void check_touching(const Scene& scene, const Onset& onset);

/// Refuses, at `place`, what a transform may have pushed or rounded into something else: an empty domain,
/// particles deeper than half the smaller radius in each other or in a wall.
void check_still_apart(const Scene& scene, const Node& place);

/// Refuses, at `place`, a particle outside the domain.
void check_still_inside(const Scene& scene, const Node& place);

}  // namespace grainproof::input
