// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/scan.hpp"

namespace grainproof::opencl {
namespace {

constexpr std::size_t items_a_work_item = 8;  // SCAN_ITEMS of kernels/scan.cl

}  // namespace

Scan::Scan(Workshop& workshop, Program& program, std::size_t largest, std::size_t work_group)
    : workshop_(workshop), program_(program), work_group_(work_group) {
  std::size_t blocks = largest;
  do {
    blocks = blocks_of(blocks);
    const Bytes zeros(sizeof(cl_int) * blocks);
    levels_.push_back({workshop.upload(zeros), workshop.upload(zeros)});
    bytes_ += 2 * zeros.size();
  } while (blocks > 1);
}

std::size_t Scan::blocks_of(std::size_t count) const {
  const std::size_t block = work_group_ * items_a_work_item;
  return (count + block - 1) / block;
}

void Scan::exclusive(const cl::Buffer& values, const cl::Buffer& starts, std::size_t count) {
  if (count > 0) scan_level(values, starts, count, 0);
}

// A single block starts at zero, which is what the last level's starts hold for ever.
void Scan::scan_level(const cl::Buffer& values, const cl::Buffer& starts, std::size_t count,
                      std::size_t level) {
  const std::size_t blocks = blocks_of(count);
  const Range range{blocks * work_group_, work_group_};
  const cl::LocalSpaceArg partial = cl::Local(work_group_ * sizeof(cl_int));
  const auto n = static_cast<cl_int>(count);
  if (blocks > 1) {
    workshop_.launch(program_, "scan_reduce", range, values, levels_[level].sums, partial, n);
    scan_level(levels_[level].sums, levels_[level].starts, blocks, level + 1);
    workshop_.launch(program_, "scan_blocks", range, values, levels_[level].starts, starts, partial, n);
  } else {
    workshop_.launch(program_, "scan_blocks", range, values, levels_.back().starts, starts, partial, n);
  }
}

}  // namespace grainproof::opencl
