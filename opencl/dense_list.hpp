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
  cl::Buffer heads, list, springs, marks;
};

/// Bytes of all of a world's buffers.
std::size_t size_of(const DenseWorld& world);

/// Builds the list anew, with the particles put in order of zones first: all on the device but for its
/// length.
///
/// There is one list, and hardly any room beside it: springs are packed before the old list is written over,
/// and all else stands meanwhile in that copy of the records which is not in use.
class DenseList {
 public:
  DenseList(Workshop& workshop, DenseWorld& world, const DenseImage& image, const DenseOptions& options,
            const DenseGrid& grid, std::size_t work_group);

  /// For the records of boundary parity `turn`; the other copy is overwritten. Springs are carried over;
  /// `rows_taken` is how many rows of them the last list has come to.
  void build(DenseWorld& world, Program& program, int turn, std::int64_t rows_taken);

  /// Whether the last build found a particle with more partners than the program has room for; the list is
  /// then of no use, and is to be built again by a program with more.
  bool crowded() const { return crowded_; }
  void build_again(DenseWorld& world, Program& program, int turn);

  /// Zones of another skin, from the next list on.
  void use_grid(DenseWorld& world, const DenseGrid& grid);

  std::int64_t slots() const { return slots_; }
  /// Of springs, one for a span: in use when the list was made, and all there are.
  std::int64_t rows() const { return rows_; }
  std::int64_t row_room() const { return row_room_; }
  std::size_t springs_bytes() const;
  std::size_t bytes() const;

  /// dense_checkpoint.cpp
  void pack_into(Sections& own, const DenseWorld& world) const;
  void unpack_from(const Sections& own, DenseWorld& world);

 private:
  /// Rooms within one copy of the records, for as long as a list is made.
  struct Scratch {
    cl::Buffer coarse, zone_of_particle, zones_of, starts, zone_counts, zone_starts;
    cl::Buffer kept, ids, cells;  ///< when the others are done with
  };

  Scratch scratch_in(cl::Buffer& records);
  void pack_springs(DenseWorld& world, Program& program, const Scratch& scratch);
  void find(DenseWorld& world, Program& program, int turn, const Scratch& scratch);
  void fill_zones(DenseWorld& world, Program& program, int turn, const Scratch& scratch);
  void make_room(DenseWorld& world);
  void make_row_room(DenseWorld& world);
  std::int64_t most_rows() const { return slots_ * static_cast<std::int64_t>(spans_); }
  std::int64_t first_reserve() const { return (most_rows() - rows_) / 12 + 16; }
  void count(DenseWorld& world, Program& program, const Scratch& scratch);
  void write_down(DenseWorld& world, Program& program, int turn, const Scratch& scratch);
  void settle(DenseWorld& world, Program& program, int turn);

  Workshop& workshop_;
  const DenseOptions& options_;
  std::size_t particles_, padded_, zones_ = 0, group_, spans_, work_group_;
  std::optional<Scan> scan_;
  cl::Buffer own_zone_counts_, own_zone_starts_;  ///< where the records have no room for them
  std::array<Scratch, 2> scratch_;                ///< in the same order as the records
  cl::Buffer members_, order_, places_;           ///< where `built_at` is
  cl::Buffer totals_, partners_, packed_;
  std::int64_t room_ = 0, slots_ = 0;
  std::int64_t row_room_ = 0, rows_ = 0, reserve_ = 0;
  std::int64_t packed_room_ = 0;
  bool crowded_ = false;
};

}  // namespace grainproof::opencl
