// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "opencl/layout.hpp"
#include "opencl/run.hpp"

namespace grainproof::opencl {

/// A scene small enough for one work-group: one launch takes many steps.
class SmallRun : public DeviceRun {
 public:
  SmallRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const BuildOptions& options);

  /// Particles up to which this path is taken.
  static constexpr std::size_t most_particles = 64;

 protected:
  void take_steps(std::int64_t steps) override;
  void settle() override;
};

}  // namespace grainproof::opencl
