// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/small_run.hpp"

#include <algorithm>
#include <bit>

namespace grainproof::opencl {
namespace {

/// Bounds the table of a time-dependent field, and how long a device is kept from answering.
constexpr std::int64_t steps_a_launch = 1 << 16;

std::size_t group_for(const Scene& scene) {
  return std::bit_ceil(std::max<std::size_t>(scene.particles.size(), 1));
}

}  // namespace

SmallRun::SmallRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const BuildOptions& options)
    : DeviceRun(std::move(workshop), scene, options, ZoneGrid{}, group_for(scene)) {}

void SmallRun::take_steps(std::int64_t steps) {
  const std::int64_t end = done() + steps;
  std::int64_t first = done();
  do {
    const std::int64_t last = std::min(end, first + steps_a_launch);
    use_gravity_of_steps(first, last);
    // A launch from step 0 also takes the forces of step 0, so it must be the first one.
    launch_in_world(*workshop_, program_, "run_small", particles_, world_, static_cast<cl_int>(first),
                    static_cast<cl_int>(last));
    first = last;
  } while (first < end);
}

void SmallRun::settle() {
  std::array<cl_int, signal_count> signals{};
  workshop_->read(world_.signals, std::as_writable_bytes(std::span(signals)));
  check_signals(signals);
}

}  // namespace grainproof::opencl
