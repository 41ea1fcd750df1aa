// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/observations.hpp"
#include "model/scene.hpp"

/// Scenes that are run for a million bounces, ten million steps, hundreds of periods: docs/benchmarks.md.
namespace grainproof::bench {

/// What is looked at, and in what; a scene's own meaning of each stands in docs/benchmarks.md.
enum class Look : std::size_t { energy, momentum, position, overlap, speed, lost };
inline constexpr std::size_t looks = 6;

/// A value a look.
using Seen = std::array<double, looks>;

constexpr double& at(Seen& seen, Look look) {
  return seen[static_cast<std::size_t>(look)];
}
constexpr double at(const Seen& seen, Look look) {
  return seen[static_cast<std::size_t>(look)];
}

struct LongPlan {
  std::string name;  ///< "bounces", "pile", "vibrated"
  Scene scene;
  std::int64_t steps;
  int windows;          ///< a checkpoint may be written after each
  int frames;           ///< looked at in a window
  bool in_a_row;        ///< at its last steps, one after the other; else evenly over it
  double contact_s;     ///< shortest contact, s
  double unit_speed;    ///< m/s: approach of the pair, else of what falls a diameter
  double unit_overlap;  ///< m: largest of the first bounce, or of the pile at rest; else a diameter
};

/// `quick` takes a hundredth of the steps. Throws InputRefused for another name.
LongPlan long_plan(const std::string& name, Integrator integrator, bool quick);

Seen seen(const LongPlan& plan, const Frame& frame);

/// The frame that the scene itself starts with.
Frame first_frame(const Scene& scene);

/// A pair that bounces across both faces of a periodic box; steps that pass from one touch to the next.
double steps_a_bounce(const LongPlan& plan);

}  // namespace grainproof::bench
