// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "model/engine.hpp"
#include "opencl/precision.hpp"

namespace grainproof::opencl {

/// Whether the dense path can take a scene: one kind of linear contact between many spheres, planes, constant
/// gravity. `no` says what it lacks. Pure: no device is asked.
Support dense_support(const Scene& scene, const Request& request, double skin, bool one = false);

/// What a program of the dense path must be able to do for a scene, and nothing else.
struct DenseOptions {
  Precision precision = Precision::double_precision;
  bool friction = false;  ///< any without history
  bool history = false;
  int history_variant = 0;  ///< HistoryBit, of the law between particles
  bool rotation = false;
  bool planes = false;
  bool predicted = false;  ///< forces take velocities predicted for the boundary
  bool corrected = false;  ///< contacts that begin or end act for as long as they last
  bool varied = false;     ///< particles differ in size, or some are fixed
  bool canonical = false;  ///< sums do not depend on the order of contacts
  bool one = false;        ///< particle a work-item: kernels/wide_*_1.cl
  int most_partners = 64;

  bool operator==(const DenseOptions&) const = default;
};

DenseOptions dense_options(const Scene& scene, Precision precision, bool one = false);

/// In the order of the program, names within kernels/; `pocl` takes math_pocl.cl.
std::vector<std::string> dense_kernel_files(const DenseOptions& options, bool pocl);
std::string dense_definitions(const DenseOptions& options);

/// Particles of a work-item: LANES of kernels/wide_*.cl.
constexpr int lanes_of(const DenseOptions& options) {
  if (options.one) return 1;
  return options.precision == Precision::double_precision ? 8 : 16;
}

/// Particles that stand together in a group, and whose entries fill a slot of its list: GROUP there.
constexpr int group_size(const DenseOptions& options) {
  return options.one ? 32 : lanes_of(options);
}

/// Work-items that share a group, each with marks of its own: kernels/dense_springs.cl.
constexpr int spans_of(const DenseOptions& options) {
  return group_size(options) / lanes_of(options);
}

/// Particles in order of zones that are searched for, and then put in order of their counts, together.
inline constexpr int window_size = 128;

/// Vectors of four that a particle has: place, motion and, where bodies turn, spin; where velocities are
/// predicted also motion in the middle of the step, and the spin there, which has
/// the fourth places of the three before where particles are all alike.
constexpr int quarters_of(const DenseOptions& options) {
  const bool spin_apart = options.predicted && options.rotation && options.varied;
  return 2 + (options.rotation ? 1 : 0) + (options.predicted ? 1 : 0) + (spin_apart ? 1 : 0);
}

/// Where those of the middle begin.
constexpr int middle_quarter(const DenseOptions& options) {
  return options.rotation ? 3 : 2;
}

/// Words that a slot of the list has besides its entries, kernels/dense_springs.cl.
constexpr std::size_t mark_words(const DenseOptions& options) {
  return (options.history ? 1 : 0) + (options.corrected ? 1 : 0);
}

/// What the entries of a list count in: eight bytes, kernels/wide_*.cl.
constexpr int units_a_record(const DenseOptions& options) {
  return quarters_of(options) * (options.precision == Precision::double_precision ? 4 : 2);
}

/// Numbers that a particle keeps to itself, kernels/wide_*.cl.
constexpr int kept_numbers(Precision precision) {
  return precision == Precision::double_precision ? 0 : 6;
}

}  // namespace grainproof::opencl
