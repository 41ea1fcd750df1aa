// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/dense_list.hpp"

#include <algorithm>
#include <span>

#include "opencl/bytes.hpp"

namespace grainproof::opencl {
namespace {

constexpr std::size_t padded_to(std::size_t count, std::size_t group) {
  return (count + group - 1) / group * group;
}

cl::Buffer integers(Workshop& workshop, std::size_t count) {
  return workshop.upload(Bytes(sizeof(cl_int) * (count + 1)));
}

std::size_t real_bytes(const DenseOptions& options) {
  return options.precision == Precision::double_precision ? 8 : 4;
}

}  // namespace

DenseList::DenseList(Workshop& workshop, const DenseImage& image, const DenseOptions& options,
                     const DenseGrid& grid, std::size_t work_group)
    : workshop_(workshop),
      options_(options),
      particles_(image.particles),
      padded_(image.padded),
      zones_(static_cast<std::size_t>(grid.zones())),
      group_(static_cast<std::size_t>(group_size(options.precision))),
      work_group_(work_group),
      zone_counts_(integers(workshop, zones_)),
      zone_starts_(integers(workshop, zones_)),
      zone_of_particle_(integers(workshop, padded_)),
      members_(integers(workshop, padded_)),
      zones_of_(integers(workshop, padded_)),
      order_(integers(workshop, padded_)),
      places_(integers(workshop, padded_)),
      coarse_(workshop.room(4 * sizeof(cl_uint) * padded_)),
      totals_(integers(workshop, 1)),
      kept_(workshop.room(image.kept.size())),
      ids_(integers(workshop, padded_)),
      cells_(workshop.room(image.cells.size())),
      old_heads_(workshop.upload(Bytes(sizeof(cl_int4) * padded_ / group_))),
      old_list_(integers(workshop, 0)),
      old_springs_(integers(workshop, 0)),
      old_strained_(integers(workshop, 0)) {}

void DenseList::build(DenseWorld& world, Program& program, int turn) {
  if (!scan_) scan_.emplace(workshop_, program, zones_ + 1, work_group_);
  fill_zones(world, program, turn);
  workshop_.launch(program, "dense_coarse", {padded_, work_group_}, world.box, members_, zone_of_particle_,
                   world.records[turn], world.cells, zones_of_, coarse_, static_cast<cl_int>(padded_));
  std::swap(world.heads, old_heads_);
  std::swap(world.list, old_list_);
  std::swap(world.springs, old_springs_);
  std::swap(world.strained, old_strained_);
  std::swap(room_, old_room_);
  build_again(world, program, turn);
}

void DenseList::fill_zones(DenseWorld& world, Program& program, int turn) {
  const Range particles{padded_, work_group_};
  workshop_.launch(program, "dense_zone_count", particles, world.box, world.records[turn], world.built_at,
                   world.cells, zone_counts_, zone_of_particle_);
  scan_->exclusive(zone_counts_, zone_starts_, zones_ + 1);
  workshop_.launch(program, "dense_zone_fill", particles, zone_of_particle_, zone_starts_, zone_counts_,
                   members_, static_cast<cl_int>(particles_));
  workshop_.launch(program, "dense_zone_order", {padded_to(zones_, work_group_), work_group_}, zone_starts_,
                   members_, static_cast<cl_int>(zones_));
}

void DenseList::build_again(DenseWorld& world, Program& program, int turn) {
  find(world, program, turn);
  if (crowded_) return;
  workshop_.launch(program, "dense_permute", {padded_, work_group_}, order_, members_, world.records[turn],
                   world.kept, world.ids, world.cells, world.records[1 - turn], kept_, ids_, cells_,
                   world.built_at);
  workshop_.launch(program, "dense_rename", {padded_ / group_, 8}, world.heads, places_, world.list,
                   static_cast<cl_int>(room_));
  std::swap(world.records[0], world.records[1]);
  std::swap(world.kept, kept_);
  std::swap(world.ids, ids_);
  std::swap(world.cells, cells_);
}

void DenseList::find(DenseWorld& world, Program& program, int turn) {
  while (true) {
    std::array<cl_int, 2> totals{};
    workshop_.write(totals_, std::as_bytes(std::span(totals)));
    workshop_.launch(program, "dense_list", {padded_ / window_size, 1}, world.box, world.planes,
                     world.records[turn], world.cells, coarse_, zones_of_, zone_starts_, members_, old_heads_,
                     old_list_, old_springs_, old_strained_, world.heads, world.list, world.springs,
                     world.strained, order_, places_, totals_, static_cast<cl_int>(padded_),
                     static_cast<cl_int>(room_));
    workshop_.read(totals_, std::as_writable_bytes(std::span(totals)));
    slots_ = totals[0];
    crowded_ = totals[1] != 0;
    if (crowded_ || slots_ <= room_) return;
    make_room(world, slots_);
  }
}

void DenseList::make_room(DenseWorld& world, std::int64_t slots) {
  room_ = slots + slots / 16 + 64;
  const std::size_t entries = static_cast<std::size_t>(room_) * group_;
  world.list = workshop_.room(sizeof(cl_int) * entries);
  world.strained = workshop_.room(sizeof(cl_int) * static_cast<std::size_t>(room_));
  if (options_.history) world.springs = workshop_.room(3 * real_bytes(options_) * entries);
}

}  // namespace grainproof::opencl
