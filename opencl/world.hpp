// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <tuple>
#include <utility>

#include "opencl/workshop.hpp"

namespace grainproof::opencl {

/// The buffers behind WORLD_PARAMETERS of kernels/world.cl.
struct World {
  cl::Buffer box, constants, laws, planes, rectangles, cylinders, materials, reaches, drag_rates;
  cl::Buffer gravity_table, stands;
  cl::Buffer positions, velocities, rests, accelerations, reported, tallies, sums, faults, signals;
  cl::Buffer wall_tallies, wall_sums;
  cl::Buffer spins, spin_rests, angular_accelerations, reported_spins, orientations, orientation_rests;
  cl::Buffer middles, spin_middles, corrections;
  cl::Buffer springs, wall_springs;
  cl_int table_origin = 0;

  auto arguments() const {
    return std::tie(box, constants, laws, planes, rectangles, cylinders, materials, reaches, drag_rates,
                    gravity_table, stands, positions, velocities, rests, accelerations, reported, tallies,
                    sums, wall_tallies, wall_sums, spins, spin_rests, angular_accelerations, reported_spins,
                    orientations, orientation_rests, middles, spin_middles, corrections, springs,
                    wall_springs, faults, signals, table_origin);
  }
};

/// Bytes that one contact's memory takes.
inline std::size_t memory_bytes(const BuildOptions& options, const Decoder& decoder) {
  return options.memory_words() * decoder.vector_bytes();
}

/// Uploads a scene. What the options leave out holds one entry that nothing reads. The springs of a list are
/// the list's own.
World make_world(Workshop& workshop, const SceneImage& image, const Decoder& decoder,
                 const BuildOptions& options);

/// Launches a kernel whose first parameters are the world.
template <class... More>
void launch_in_world(Workshop& workshop, Program& program, const std::string& name, Range range,
                     const World& world, const More&... more) {
  std::apply([&](const auto&... all) { workshop.launch(program, name, range, all...); },
             std::tuple_cat(world.arguments(), std::tie(more...)));
}

}  // namespace grainproof::opencl
