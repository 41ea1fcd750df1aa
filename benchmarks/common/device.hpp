// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "benchmarks/common/settings.hpp"
#include "opencl/cl.hpp"

namespace grainproof::bench {

/// A device with one queue, for kernels of the benchmarks' own.
class Device {
 public:
  /// The device that an engine would take. `sources`: a file below benchmarks/ of the data folder.
  Device(const Settings& settings, const std::string& sources, const std::string& options = "");

  cl::Buffer room(std::size_t bytes);
  cl::Kernel kernel(const std::string& name);
  const cl::CommandQueue& queue() const { return queue_; }

  /// Seconds of `times` launches, after one that is not counted.
  double seconds(const cl::Kernel& kernel, std::size_t items, std::size_t group, int times = 1);

 private:
  cl::Device device_;
  cl::Context context_;
  cl::CommandQueue queue_;
  cl::Program program_;
};

}  // namespace grainproof::bench
