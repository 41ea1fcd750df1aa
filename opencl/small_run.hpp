// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <span>
#include <vector>

#include "opencl/layout.hpp"
#include "opencl/run.hpp"

namespace grainproof::opencl {

/// A scene small enough for one work-group: one launch takes many steps.
class SmallRun : public DeviceRun {
 public:
  SmallRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const BuildOptions& options);

  /// The device takes the frames on its way, so that one costs next to nothing.
  void record(std::span<const std::int64_t> steps, std::vector<Frame>& frames) override;

  /// Particles up to which this path is taken.
  static constexpr std::size_t most_particles = 64;

 protected:
  void take_steps(std::int64_t steps) override;
  void settle() override;
  std::vector<ContactMemory> pair_memories() override;
  void pack_path(Sections& own) override;
  void unpack_path(const Sections& own) override;

 private:
  /// Frames that the device writes down during the launches of one record().
  struct Samples {
    std::vector<cl_int> steps;
    cl::Buffer steps_on_device, positions, velocities, spins, orientations;
  };

  Samples make_samples(std::span<const std::int64_t> steps);
  void remember_pairs();
  void record_some(std::span<const std::int64_t> steps, std::vector<Frame>& frames);

  Samples none_;
  Samples* samples_ = &none_;
};

}  // namespace grainproof::opencl
