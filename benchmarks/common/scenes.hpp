// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "model/scene.hpp"

/// The bed and the gas that every suite measures: spheres of 1 mm and 2500 kg/m³, k_n 1000 N/m, k_t 2/7 of
/// it, restitution 0.9, µ 0.5, rotation, steps of 2 µs (a fortieth of a contact).
namespace grainproof::bench {

inline constexpr double diameter = 1e-3;     // m
inline constexpr double density = 2500.0;    // kg/m³
inline constexpr double stiffness = 1000.0;  // N/m
inline constexpr double time_step = 2e-6;    // s
inline constexpr double restitution = 0.9;
inline constexpr double friction = 0.5;
inline constexpr double gas_packing = 0.1;
inline constexpr std::int64_t tile_particles = 10000;

/// Laws that the peers have too: a tangential spring with half the normal dashpot.
ContactLaws usual_laws();

/// Domain, one material, laws, step; no particles.
Scene empty_scene(const Vec3& extent);

/// A settled bed 23 diameters deep on a floor, periodic along x and y. The tile that it is made of is settled
/// once by the reference engine and kept in `cache`; `particles` is rounded to whole tiles (of 900 particles
/// below 10 000). Springs are new.
Scene bed(std::int64_t particles, const std::filesystem::path& cache);

/// Spheres put down at random in a periodic cube, speeds of 1 m/s (rms).
Scene gas(std::int64_t particles);

/// "bed" or "gas". Throws InputRefused for another name.
Scene scene_named(const std::string& name, std::int64_t particles, const std::filesystem::path& cache);

/// "bed_10k", "gas_1m", …
std::string sized_name(const std::string& name, std::int64_t particles);

}  // namespace grainproof::bench
