// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "benchmarks/common/accuracy_scene.hpp"
#include "model/engine.hpp"

namespace grainproof::bench {

/// Whose variant of the laws.
enum class Variant { ours_and_lammps, liggghts };

struct Exact {
  std::vector<Vec3> velocity;  ///< as compared() has it
  double uncertainty = 0.0;    ///< error of this solution itself: its distance to that of twice the step
};

/// Where no closed form is known: the reference engine's solution, with the most accurate integrator that it
/// has. Computed once a process.
const Exact& fine_solution(const AccuracyScene& scene, Variant variant);

/// Velocities of all particles after `steps`, and how long the loop took.
struct Stepped {
  std::vector<Vec3> velocity;
  double seconds = 0.0;
};

Stepped step_through(SteppingEngine& engine, const Scene& scene, std::int64_t steps);

}  // namespace grainproof::bench
