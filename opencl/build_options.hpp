// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string>
#include <vector>

#include "model/engine.hpp"
#include "opencl/precision.hpp"

namespace grainproof::opencl {

enum class FlowKind { none, uniform, taylor_green };
enum class GravityKind { none, constant, rotating, central };

/// What a program must be able to do for a scene, and nothing else.
struct BuildOptions {
  Precision precision = Precision::double_precision;
  Integrator integrator = Integrator::velocity_verlet;
  bool friction = false;  ///< any without history
  bool history = false;
  bool hertz = false;
  bool rotation = false;
  bool cohesion = false;
  bool planes = false;
  bool rectangles = false;
  bool cylinders = false;
  bool moving_walls = false;
  bool rolling_constant = false;
  bool rolling_spring = false;
  OrientationUpdate orientation = OrientationUpdate::none;
  std::array<bool, 3> periodic{};
  FlowKind flow = FlowKind::none;
  GravityKind gravity = GravityKind::none;
  bool many_materials = false;
  bool ledger = false;
  bool small = false;  ///< one work-group, all pairs

  /// Forces take velocities predicted for the boundary.
  bool predicts() const { return integrator == Integrator::velocity_verlet_predicted || corrects(); }
  /// Contacts that begin or end within a step act for the time that they lasted.
  bool corrects() const { return integrator == Integrator::onset_corrected; }
  /// Each dashpot takes the velocity that it leaves; springs are evaluated before.
  bool implicit_dashpots() const { return integrator == Integrator::velocity_verlet_implicit; }
  /// Velocities in the middle of the step are held beside those that forces take.
  bool holds_middles() const { return predicts() || implicit_dashpots(); }
  /// Contacts have a memory: of their springs, or of being there.
  bool remembers() const { return history || corrects(); }
  /// Springs keep what rounding leaves out of their stretch.
  bool keeps_rests() const { return history && precision != Precision::double_precision; }
  /// Vectors that one contact's memory takes: its spring, a spring against rolling, the rest.
  std::size_t memory_words() const { return 1u + (rolling_spring ? 1u : 0u) + (keeps_rests() ? 1u : 0u); }

  bool operator==(const BuildOptions&) const = default;
};

/// What `scene` and `request` need. Pure: no device is asked.
BuildOptions build_options(const Scene& scene, const Request& request, Precision precision, bool small);

/// `lean` and every stage that cannot change its scene's physics.
BuildOptions with_every_stage(BuildOptions lean);

/// Those of a program that say what a number is, and what all kernels share; they come first.
std::vector<std::string> number_files(Precision precision, bool pocl);

/// The kernel files of a program, in order. `pocl` takes clang's builtins instead of the library's functions.
std::vector<std::string> kernel_files(const BuildOptions& options, bool pocl);

/// Compiler definitions, "-D PERIODIC_X=0 …".
std::string definitions(const BuildOptions& options);

}  // namespace grainproof::opencl
