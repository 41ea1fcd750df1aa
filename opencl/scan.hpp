// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "opencl/workshop.hpp"

namespace grainproof::opencl {

/// Exclusive scan of up to `largest` integers on the device, with room for the sums of blocks kept.
class Scan {
 public:
  Scan(Workshop& workshop, Program& program, std::size_t largest, std::size_t work_group);

  /// starts[i] = values[0] + … + values[i−1] for i < count. `values` and `starts` are different buffers.
  void exclusive(const cl::Buffer& values, const cl::Buffer& starts, std::size_t count);

  std::size_t bytes() const { return bytes_; }

 private:
  struct Level {
    cl::Buffer sums;
    cl::Buffer starts;
  };

  void scan_level(const cl::Buffer& values, const cl::Buffer& starts, std::size_t count, std::size_t level);
  std::size_t blocks_of(std::size_t count) const;

  Workshop& workshop_;
  Program& program_;
  std::size_t work_group_;
  std::vector<Level> levels_;
  std::size_t bytes_ = 0;
};

}  // namespace grainproof::opencl
