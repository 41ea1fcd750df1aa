// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/dense_list.hpp"

#include <algorithm>
#include <span>

#include "opencl/bytes.hpp"

namespace grainproof::opencl {
namespace {

/// What a list's kernels count: kernels/dense_springs.cl.
enum Total { slots_wanted, crowded_rows, rows_wanted, springs_packed, total_count };
using Totals = std::array<cl_int, total_count>;

constexpr std::size_t padded_to(std::size_t count, std::size_t group) {
  return (count + group - 1) / group * group;
}

std::size_t real_bytes(const DenseOptions& options) {
  return options.precision == Precision::double_precision ? 8 : 4;
}

std::size_t size_of(const cl::Buffer& buffer) {
  return buffer() == nullptr ? 0 : buffer.getInfo<CL_MEM_SIZE>();
}

/// A little more than asked for, so that not every list asks anew.
constexpr std::int64_t with_slack(std::int64_t wanted) {
  return wanted + wanted / 128 + 32;
}

/// Nor is there room for half as much again, once a skin has shrunk.
bool fits(std::int64_t needed, std::int64_t wanted, std::int64_t room) {
  return room > 0 && needed <= room && room <= with_slack(wanted) * 3 / 2;
}

}  // namespace

std::size_t size_of(const DenseWorld& w) {
  std::size_t sum = 0;
  for (const cl::Buffer* buffer : {&w.box, &w.laws, &w.planes, &w.records[0], &w.records[1], &w.kept,
                                   &w.built_at, &w.cells, &w.ids, &w.heads, &w.list, &w.springs, &w.marks})
    sum += size_of(*buffer);
  return sum;
}

DenseList::DenseList(Workshop& workshop, DenseWorld& world, const DenseImage& image,
                     const DenseOptions& options, const DenseGrid& grid, std::size_t work_group)
    : workshop_(workshop),
      options_(options),
      particles_(image.particles),
      padded_(image.padded),
      group_(static_cast<std::size_t>(group_size(options))),
      spans_(static_cast<std::size_t>(spans_of(options))),
      work_group_(work_group),
      totals_(workshop.room(sizeof(Totals))),
      partners_(workshop.room(64)),
      packed_(workshop.room(64)) {
  use_grid(world, grid);
  const std::size_t row = sizeof(cl_int) * padded_;
  members_ = workshop_.part(world.built_at, 0, row);
  order_ = workshop_.part(world.built_at, row, row);
  places_ = workshop_.part(world.built_at, 2 * row, row);
}

void DenseList::use_grid(DenseWorld& world, const DenseGrid& grid) {
  zones_ = static_cast<std::size_t>(grid.zones());
  reserve_ = 0;
  scan_.reset();
  own_zone_counts_ = own_zone_starts_ = {};
  scratch_ = {};
  scratch_ = {scratch_in(world.records[0]), scratch_in(world.records[1])};
}

std::size_t DenseList::bytes() const {
  return size_of(own_zone_counts_) + size_of(own_zone_starts_) + size_of(totals_) + size_of(partners_) +
         size_of(packed_) + (scan_ ? scan_->bytes() : 0);
}

std::size_t DenseList::springs_bytes() const {
  return 3 * real_bytes(options_) * static_cast<std::size_t>(row_room_) * (group_ / spans_);
}

DenseList::Scratch DenseList::scratch_in(cl::Buffer& records) {
  const std::size_t row = sizeof(cl_int) * padded_, all = size_of(records);
  const std::size_t kept = real_bytes(options_) * static_cast<std::size_t>(kept_numbers(options_.precision));
  const std::size_t zones = padded_to(sizeof(cl_int) * (zones_ + 1), 512);
  std::size_t at = 0;
  const auto next = [&](std::size_t bytes) {
    at += bytes;
    return workshop_.part(records, at - bytes, bytes);
  };
  Scratch s{next(4 * row), next(row), next(row), next(row), {}, {}, {}, {}, {}};
  if (at + 2 * zones <= all) {
    s.zone_counts = next(zones);
    s.zone_starts = next(zones);
  } else {
    if (own_zone_counts_() == nullptr) own_zone_counts_ = workshop_.room(zones);
    if (own_zone_starts_() == nullptr) own_zone_starts_ = workshop_.room(zones);
    s.zone_counts = own_zone_counts_;
    s.zone_starts = own_zone_starts_;
  }
  at = 0;
  s.kept = next(std::max<std::size_t>(kept * padded_, 512));
  s.ids = next(row);
  s.cells = next(row);
  return s;
}

// As many rows beyond those of the start as the last list has come to; where it ran short, four times as
// many, though never more than there are slots.
void DenseList::build(DenseWorld& world, Program& program, int turn, std::int64_t rows_taken) {
  if (!scan_) scan_.emplace(workshop_, program, zones_ + 1, work_group_);
  reserve_ = rows_taken >= row_room_ ? std::min(std::max(4 * reserve_, first_reserve()), most_rows() - rows_)
                                     : std::max(reserve_, (rows_taken - rows_) * 9 / 8);
  const auto other = static_cast<std::size_t>(1 - turn);
  const Scratch& scratch = scratch_[other];
  if (mark_words(options_) > 0) pack_springs(world, program, scratch);
  fill_zones(world, program, turn, scratch);
  workshop_.launch(program, "dense_coarse", {padded_, work_group_}, world.box, members_,
                   scratch.zone_of_particle, world.records[1 - other], world.cells, scratch.zones_of,
                   scratch.coarse, static_cast<cl_int>(padded_));
  build_again(world, program, turn);
}

void DenseList::pack_springs(DenseWorld& world, Program& program, const Scratch& scratch) {
  while (true) {
    Totals totals{};
    workshop_.write(totals_, std::as_bytes(std::span(totals)));
    workshop_.launch(program, "dense_pack", {padded_ * spans_ / group_, options_.one ? work_group_ : 8},
                     world.heads, world.list, world.springs, world.marks, scratch.starts, partners_, packed_,
                     totals_, static_cast<cl_int>(packed_room_));
    workshop_.read(totals_, std::as_writable_bytes(std::span(totals)));
    if (totals[springs_packed] <= packed_room_) return;
    packed_room_ = with_slack(totals[springs_packed]);
    partners_ = packed_ = {};
    partners_ = workshop_.room(sizeof(cl_uint) * static_cast<std::size_t>(packed_room_));
    const std::size_t reals = options_.history ? 3 * static_cast<std::size_t>(packed_room_) : 16;
    packed_ = workshop_.room(reals * real_bytes(options_));
  }
}

void DenseList::fill_zones(DenseWorld& world, Program& program, int turn, const Scratch& scratch) {
  const Range particles{padded_, work_group_}, zones{padded_to(zones_ + 1, work_group_), work_group_};
  workshop_.launch(program, "dense_zone_clear", zones, scratch.zone_counts, static_cast<cl_int>(zones_ + 1));
  workshop_.launch(program, "dense_zone_count", particles, world.box, world.records[turn], world.built_at,
                   world.cells, scratch.zone_counts, scratch.zone_of_particle);
  scan_->exclusive(scratch.zone_counts, scratch.zone_starts, zones_ + 1);
  workshop_.launch(program, "dense_zone_fill", particles, scratch.zone_of_particle, scratch.zone_starts,
                   scratch.zone_counts, members_, static_cast<cl_int>(particles_));
  workshop_.launch(program, "dense_zone_order", zones, scratch.zone_starts, members_,
                   static_cast<cl_int>(zones_));
}

void DenseList::build_again(DenseWorld& world, Program& program, int turn) {
  find(world, program, turn, scratch_[static_cast<std::size_t>(1 - turn)]);
  if (crowded_) return;
  if (!options_.one)
    workshop_.launch(program, "dense_rename", {padded_ / group_, 8}, world.heads, places_, world.list);
  settle(world, program, turn);
}

// The records first; then their old copy is room for the rest on its way.
void DenseList::settle(DenseWorld& world, Program& program, int turn) {
  const Range particles{padded_, work_group_};
  const auto from = static_cast<std::size_t>(turn);
  const Scratch& scratch = scratch_[from];
  workshop_.launch(program, "dense_permute", particles, order_, members_, world.records[from],
                   world.records[1 - from]);
  workshop_.launch(program, "dense_permute_rest", particles, order_, members_, world.kept, world.ids,
                   world.cells, scratch.kept, scratch.ids, scratch.cells);
  workshop_.launch(program, "dense_settle", particles, world.records[1 - from], scratch.kept, scratch.ids,
                   scratch.cells, world.kept, world.ids, world.cells, world.built_at);
  std::swap(world.records[0], world.records[1]);
  std::swap(scratch_[0], scratch_[1]);
}

// The zones of particles in the order of before have been read by then: there is room for counts.
void DenseList::count(DenseWorld& world, Program& program, const Scratch& scratch) {
  workshop_.launch(program, "dense_count", {padded_, window_size}, world.box, scratch.coarse,
                   scratch.zones_of, scratch.zone_starts, scratch.zone_of_particle, order_, places_,
                   static_cast<cl_int>(padded_));
}

void DenseList::write_down(DenseWorld& world, Program& program, int turn, const Scratch& scratch) {
  const auto padded = static_cast<cl_int>(padded_), room = static_cast<cl_int>(room_),
             row_room = static_cast<cl_int>(row_room_);
  const auto& records = world.records[static_cast<std::size_t>(turn)];
  if (options_.one)
    workshop_.launch(program, "dense_list", {padded_, window_size}, world.box, world.planes, records,
                     world.cells, scratch.coarse, scratch.zones_of, scratch.zone_starts, members_,
                     scratch.starts, partners_, packed_, world.heads, world.list, world.springs, world.marks,
                     order_, places_, scratch.zone_of_particle, totals_, padded, room, row_room);
  else
    workshop_.launch(program, "dense_list", {padded_ / window_size, 1}, world.box, world.planes, records,
                     world.cells, scratch.coarse, scratch.zones_of, scratch.zone_starts, members_,
                     scratch.starts, partners_, packed_, world.heads, world.list, world.springs, world.marks,
                     order_, places_, totals_, padded, room, row_room);
}

void DenseList::find(DenseWorld& world, Program& program, int turn, const Scratch& scratch) {
  if (options_.history && rows_ + reserve_ > row_room_) make_row_room(world);
  if (options_.one) count(world, program, scratch);
  while (true) {
    Totals totals{};
    workshop_.write(totals_, std::as_bytes(std::span(totals)));
    write_down(world, program, turn, scratch);
    workshop_.read(totals_, std::as_writable_bytes(std::span(totals)));
    slots_ = totals[slots_wanted];
    rows_ = totals[rows_wanted];
    crowded_ = totals[crowded_rows] != 0;
    const bool slots_fit = fits(slots_, slots_, room_);
    const bool rows_fit = !options_.history || fits(rows_, rows_ + reserve_, row_room_);
    if (crowded_ || (slots_fit && rows_fit)) return;
    if (!slots_fit) make_room(world);
    if (!rows_fit) make_row_room(world);
  }
}

// What held the last list is given back before there is more.
void DenseList::make_room(DenseWorld& world) {
  room_ = with_slack(slots_);
  world.list = world.marks = {};
  world.list = workshop_.room(sizeof(cl_uint) * static_cast<std::size_t>(room_) * group_);
  world.marks = workshop_.room(sizeof(cl_int) * std::max<std::size_t>(mark_words(options_), 1) *
                               static_cast<std::size_t>(room_) * spans_);
}

void DenseList::make_row_room(DenseWorld& world) {
  reserve_ = std::max(reserve_, first_reserve());
  const auto wanted = static_cast<std::size_t>(with_slack(rows_ + reserve_));
  row_room_ = static_cast<std::int64_t>(padded_to(wanted, spans_));
  world.springs = {};
  world.springs = workshop_.room(springs_bytes());
}

}  // namespace grainproof::opencl
