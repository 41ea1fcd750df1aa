// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/sections.hpp"
#include "opencl/dense_image.hpp"
#include "opencl/scan.hpp"
#include "opencl/workshop.hpp"

namespace grainproof::opencl {

/// The particles on the device, in the order of the last list, and that list. kernels/dense_step.cl
struct DenseWorld {
  cl::Buffer box, laws, planes;
  std::array<cl::Buffer, 2> records;  ///< of even and of odd boundaries
  cl::Buffer kept, built_at, cells, ids;
  cl::Buffer heads, list, springs, strained;
};

/// Builds the list anew, with the particles put in order of zones first: all on the device but for its
/// length.
class DenseList {
 public:
  DenseList(Workshop& workshop, const DenseImage& image, const DenseOptions& options, const DenseGrid& grid,
            std::size_t work_group);

  /// For the records of boundary parity `turn`; the other copy is overwritten. Springs are carried over.
  void build(DenseWorld& world, Program& program, int turn);

  /// Whether the last build found a particle with more partners than the program has room for; the list is
  /// then of no use, and is to be built again by a program with more.
  bool crowded() const { return crowded_; }
  void build_again(DenseWorld& world, Program& program, int turn);

  std::int64_t slots() const { return slots_; }

  /// dense_checkpoint.cpp
  void pack_into(Sections& own, const DenseWorld& world) const;
  void unpack_from(const Sections& own, DenseWorld& world);

 private:
  void find(DenseWorld& world, Program& program, int turn);
  void fill_zones(DenseWorld& world, Program& program, int turn);
  void make_room(DenseWorld& world, std::int64_t slots);

  Workshop& workshop_;
  const DenseOptions& options_;
  std::size_t particles_, padded_, zones_, group_, work_group_;
  std::optional<Scan> scan_;
  cl::Buffer zone_counts_, zone_starts_, zone_of_particle_, members_, zones_of_, order_, places_, coarse_,
      totals_;
  cl::Buffer kept_, ids_, cells_;
  cl::Buffer old_heads_, old_list_, old_springs_, old_strained_;
  std::int64_t room_ = 0, old_room_ = 0, slots_ = 0;
  bool crowded_ = false;
};

}  // namespace grainproof::opencl
