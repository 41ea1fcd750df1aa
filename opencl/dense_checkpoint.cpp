// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/dense_run.hpp"

namespace grainproof::opencl {
namespace {

/// The particles in their order, and who is near a group of them.
std::array<std::pair<const char*, cl::Buffer*>, 6> kept_buffers(DenseWorld& w, std::int64_t boundary) {
  return {{{"records", &w.records[static_cast<std::size_t>(boundary & 1)]},
           {"kept", &w.kept},
           {"built_at", &w.built_at},
           {"cells", &w.cells},
           {"ids", &w.ids},
           {"heads", &w.heads}}};
}

}  // namespace

std::string DenseRun::maker() const {
  return "opencl:" + std::string(name_of(options_.precision)) + (options_.one ? " dense by one" : " dense");
}

Checkpoint DenseRun::checkpoint() {
  Checkpoint made = portable();
  made.maker = maker();
  pack_one(made.own, "done", done_);
  pack_one(made.own, "first_step", first_step_);
  pack_one(made.own, "list_rebuilds", counters_.list_rebuilds);
  pack_one(made.own, "built_at_step", built_at_);
  pack_one(made.own, "lifetime", lifetime_);
  pack_one(made.own, "most_partners", options_.most_partners);
  for (const auto& [name, buffer] : kept_buffers(world_, done_))
    pack_buffer(made.own, name, *workshop_, *buffer);
  pack_one(made.own, "rows_taken", read_signals().rows_taken);
  pack_one(made.own, "skin", grid_.skin);
  if (search_) pack_one(made.own, "search", *search_);
  list_.pack_into(made.own, world_);
  return made;
}

void DenseRun::restore(const Sections& own) {
  unpack_one(own, "done", done_);
  unpack_one(own, "first_step", first_step_);
  unpack_one(own, "list_rebuilds", counters_.list_rebuilds);
  unpack_one(own, "built_at_step", built_at_);
  unpack_one(own, "lifetime", lifetime_);
  unpack_one(own, "most_partners", options_.most_partners);
  program_ = &workshop_->program(options_);
  double skin = 0.0;
  unpack_one(own, "skin", skin);
  if (skin != grid_.skin) use_skin(skin);
  if (search_) unpack_one(own, "search", *search_);
  for (const auto& [name, buffer] : kept_buffers(world_, done_))
    unpack_buffer(own, name, *workshop_, *buffer);
  list_.unpack_from(own, world_);
  cl_int rows_taken = 0;
  unpack_one(own, "rows_taken", rows_taken);
  reset_signals(rows_taken);
  counters_.steps = first_step_ + done_;
  counters_.listed_pairs = list_.slots() * group_size(options_) / 2;
  enqueued_ = done_;
  settled_ = false;
}

void DenseRun::begin_at(const Beginning& beginning) {
  first_step_ = counters_.steps = beginning.step;
}

void DenseList::pack_into(Sections& own, const DenseWorld& world) const {
  const auto slots = static_cast<std::size_t>(slots_);
  pack_one(own, "list.slots", slots_);
  pack_buffer(own, "list.entries", workshop_, world.list, slots * group_ * sizeof(cl_uint));
  if (mark_words(options_) > 0)
    pack_buffer(own, "list.marks", workshop_, world.marks,
                slots * spans_ * mark_words(options_) * sizeof(cl_int));
  if (!options_.history) return;
  pack_one(own, "list.rows", rows_);
  pack_one(own, "list.row_room", row_room_);
  pack_one(own, "list.reserve", reserve_);
  pack_buffer(own, "list.springs", workshop_, world.springs);
}

// With room for no more slots than there are: the next list makes its own. Of rows as many as there were,
// since a list also ends where they run out.
void DenseList::unpack_from(const Sections& own, DenseWorld& world) {
  unpack_one(own, "list.slots", slots_);
  world.list = unpacked_buffer(own, "list.entries", workshop_);
  room_ = slots_;
  if (mark_words(options_) > 0) world.marks = unpacked_buffer(own, "list.marks", workshop_);
  if (!options_.history) return;
  unpack_one(own, "list.rows", rows_);
  unpack_one(own, "list.row_room", row_room_);
  unpack_one(own, "list.reserve", reserve_);
  world.springs = unpacked_buffer(own, "list.springs", workshop_);
}

}  // namespace grainproof::opencl
