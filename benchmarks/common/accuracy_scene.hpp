// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/common/pair_gas.hpp"

namespace grainproof::bench {

/// What error is measured on. Every scene ends after a whole number of contacts, so that all its steps end at
/// the same time.
struct AccuracyScene {
  std::string name;
  std::function<Scene(double steps_per_contact)> make;
  std::vector<double> steps_per_contact;
  std::optional<PairGas> gas = {};  ///< where it is one of isolated pairs
  int finer = 64;  ///< times that a reference solution's step is finer than the finest measured
};

/// Pair gases, then "packing", "gas" and "bed", of many contacts, short enough not to be chaotic. The bed's
/// tile is kept in `cache`.
std::vector<AccuracyScene> accuracy_scenes(bool quick, const std::filesystem::path& cache);

/// How many steps a scene takes to its end.
std::int64_t steps_of(const Scene& scene);

/// What is compared: of pairs the relative velocities, else all.
std::vector<Vec3> compared(const AccuracyScene& scene, const std::vector<Vec3>& velocity);

std::vector<Vec3> velocities_of(const Scene& scene);

/// Root mean square distance of two sets. Of pairs each over its own speed at the start; else over the root
/// mean square speed at the start, or at the end where the scene starts at rest.
double scene_error(const AccuracyScene& scene, const std::vector<Vec3>& found, const std::vector<Vec3>& exact,
                   const std::vector<Vec3>& start);

}  // namespace grainproof::bench
