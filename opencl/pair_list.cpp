// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/pair_list.hpp"

#include <algorithm>
#include <span>

namespace grainproof::opencl {
namespace {

constexpr std::size_t padded_to(std::size_t count, std::size_t group) {
  return (count + group - 1) / group * group;
}

/// One more than asked, so that a scan of all leaves the total at the end.
cl::Buffer integers(Workshop& workshop, std::size_t count) {
  return workshop.upload(Bytes(sizeof(cl_int) * (count + 1)));
}

}  // namespace

PairList::PairList(Workshop& workshop, Program& program, const SceneImage& image, const Decoder& decoder,
                   const ZoneGrid& grid, std::size_t work_group, std::size_t memory_bytes)
    : workshop_(workshop),
      program_(program),
      particles_(image.particles),
      padded_(image.padded),
      zones_(static_cast<std::size_t>(grid.total())),
      work_group_(work_group),
      scan_(workshop, program, std::max(zones_, padded_) + 1, work_group),
      zone_counts_(integers(workshop, zones_)),
      zone_starts_(integers(workshop, zones_)),
      zone_of_particle_(integers(workshop, padded_)),
      members_(integers(workshop, padded_)),
      pair_counts_(integers(workshop, padded_)),
      built_at_(workshop.room(padded_ * decoder.position_bytes())),
      memory_bytes_(memory_bytes) {
  for (Entries* entries : {&now_, &before_}) {
    entries->starts = integers(workshop, memory_bytes > 0 || entries == &now_ ? padded_ : 0);
    entries->partners = integers(workshop, 0);
    entries->springs = workshop.upload(Bytes(std::max<std::size_t>(memory_bytes, 1)));
  }
}

void PairList::build(const World& world) {
  const Range particles{padded_, work_group_};
  if (memory_bytes_ > 0) std::swap(now_, before_);
  fill_zones(world);
  launch_in_world(workshop_, program_, "pair_count", particles, world, zone_starts_, members_, pair_counts_);
  scan_.exclusive(pair_counts_, now_.starts, padded_ + 1);
  cl_int total = 0;
  workshop_.read(now_.starts, std::as_writable_bytes(std::span(&total, 1)), padded_ * sizeof(cl_int));
  make_room(total);
  launch_in_world(workshop_, program_, "pair_fill", particles, world, zone_starts_, members_, now_.starts,
                  now_.partners);
  if (memory_bytes_ > 0)
    workshop_.launch(program_, "carry_springs", particles, before_.starts, before_.partners, before_.springs,
                     now_.starts, now_.partners, now_.springs);
  entries_ = total;
}

void PairList::fill_zones(const World& world) {
  const Range particles{padded_, work_group_};
  const Range zones{padded_to(zones_, work_group_), work_group_};
  launch_in_world(workshop_, program_, "zone_count", particles, world, zone_counts_, zone_of_particle_,
                  built_at_);
  scan_.exclusive(zone_counts_, zone_starts_, zones_ + 1);
  workshop_.launch(program_, "zone_fill", particles, zone_of_particle_, zone_starts_, zone_counts_, members_,
                   static_cast<cl_int>(particles_));
  workshop_.launch(program_, "zone_order", zones, zone_starts_, members_, static_cast<cl_int>(zones_));
}

void PairList::make_room(std::int64_t entries) {
  if (entries <= now_.room) return;
  now_.room = entries + entries / 4;
  const auto room = static_cast<std::size_t>(now_.room);
  now_.partners = workshop_.room(sizeof(cl_int) * room);
  if (memory_bytes_ > 0) now_.springs = workshop_.room(memory_bytes_ * room);
}

}  // namespace grainproof::opencl
