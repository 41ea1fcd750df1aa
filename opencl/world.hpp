// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <tuple>
#include <utility>

#include "opencl/workshop.hpp"

namespace grainproof::opencl {

/// The buffers behind WORLD_PARAMETERS of kernels/world.cl.
struct World {
  cl::Buffer box, constants, laws, planes, rectangles, materials, reaches, drag_rates, gravity_table;
  cl::Buffer positions, velocities, rests, accelerations, reported, tallies, sums, faults, signals;
  cl::Buffer spins, spin_rests, angular_accelerations, reported_spins, springs, wall_springs;
  cl_int table_origin = 0;

  auto arguments() const {
    return std::tie(box, constants, laws, planes, rectangles, materials, reaches, drag_rates, gravity_table,
                    positions, velocities, rests, accelerations, reported, tallies, sums, spins, spin_rests,
                    angular_accelerations, reported_spins, springs, wall_springs, faults, signals,
                    table_origin);
  }
};

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
