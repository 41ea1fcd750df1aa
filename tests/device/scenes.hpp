// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"

namespace grainproof::opencl::testing {

/// Shortest time between touching and parting of a damped linear contact: π/sqrt(k/m − (η/2m)²).
double contact_time(double mass, double stiffness, double restitution);

double sphere_mass(double density, double diameter);

/// One material of density 2000, k 1e5 N/m and the given restitution, in a box of 2 m around the origin.
Scene empty_scene(double restitution);

Particle sphere(std::int64_t id, const Vec3& position, const Vec3& velocity, double diameter = 0.1);

/// A sphere at −2 m/s onto a fixed one: Andrews' normal collision.
Scene head_on_scene(double restitution, double steps_per_contact);

/// A sphere released at rest on a floor at z = 0, at the overlap zero, for `contacts` contact times.
Scene settling_scene(double contacts);

inline constexpr double stiffness = 1e5;
inline constexpr double density = 2000.0;
inline constexpr double diameter = 0.1;

}  // namespace grainproof::opencl::testing
