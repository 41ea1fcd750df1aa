// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/checkpoint.hpp"

#include <algorithm>

#include "opencl/small_run.hpp"
#include "opencl/zoned_run.hpp"

namespace grainproof::opencl {
namespace {

std::size_t size_of(const cl::Buffer& buffer) {
  return guarded("size of a buffer", "", [&] { return buffer.getInfo<CL_MEM_SIZE>(); });
}

/// What kernels change and read again, but for the springs of pairs, which each path keeps in its own way.
/// The last four are the ledger's.
std::array<std::pair<const char*, cl::Buffer*>, 20> kept_buffers(World& w) {
  return {{{"positions", &w.positions},
           {"velocities", &w.velocities},
           {"rests", &w.rests},
           {"accelerations", &w.accelerations},
           {"reported", &w.reported},
           {"spins", &w.spins},
           {"spin_rests", &w.spin_rests},
           {"angular_accelerations", &w.angular_accelerations},
           {"reported_spins", &w.reported_spins},
           {"orientations", &w.orientations},
           {"orientation_rests", &w.orientation_rests},
           {"middles", &w.middles},
           {"spin_middles", &w.spin_middles},
           {"corrections", &w.corrections},
           {"wall_springs", &w.wall_springs},
           {"faults", &w.faults},
           {"tallies", &w.tallies},
           {"sums", &w.sums},
           {"wall_tallies", &w.wall_tallies},
           {"wall_sums", &w.wall_sums}}};
}

constexpr std::size_t of_ledger = 4;

std::span<const std::pair<const char*, cl::Buffer*>> without_ledger(const auto& all, bool ledger) {
  return std::span(all).first(all.size() - (ledger ? 0 : of_ledger));
}

}  // namespace

void pack_buffer(Sections& own, const std::string& name, Workshop& workshop, const cl::Buffer& buffer) {
  pack_buffer(own, name, workshop, buffer, size_of(buffer));
}

void pack_buffer(Sections& own, const std::string& name, Workshop& workshop, const cl::Buffer& buffer,
                 std::size_t bytes) {
  Bytes read(bytes);
  if (bytes > 0) workshop.read(buffer, read);
  own[sized<std::byte>(name)] = std::move(read);
}

void unpack_buffer(const Sections& own, const std::string& name, Workshop& workshop, cl::Buffer& buffer) {
  Bytes bytes;
  unpack(own, name, bytes);
  if (bytes.size() != size_of(buffer))
    throw InputRefused("it was written by a run whose buffer '" + name + "' had " +
                       std::to_string(bytes.size()) + " bytes instead of " + std::to_string(size_of(buffer)));
  workshop.write(buffer, bytes);
}

cl::Buffer unpacked_buffer(const Sections& own, const std::string& name, Workshop& workshop) {
  Bytes bytes;
  unpack(own, name, bytes);
  bytes.resize(std::max<std::size_t>(bytes.size(), 64));
  return workshop.upload(bytes);
}

std::string DeviceRun::maker() const {
  return "opencl:" + std::string(name_of(options_.precision)) + (options_.small ? " small" : " zoned");
}

Checkpoint DeviceRun::checkpoint() {
  ensure_started();
  Checkpoint made = portable();
  made.maker = maker();
  pack_one(made.own, "done", done_);
  pack_one(made.own, "first_step", first_step_);
  pack_one(made.own, "list_rebuilds", counters_.list_rebuilds);
  const auto all = kept_buffers(world_);
  for (const auto& [name, buffer] : without_ledger(all, options_.ledger))
    pack_buffer(made.own, name, *workshop_, *buffer);
  pack_path(made.own);
  if (options_.ledger) made.ledger = ledger();
  return made;
}

void DeviceRun::restore(const Sections& own) {
  unpack_one(own, "done", done_);
  unpack_one(own, "first_step", first_step_);
  unpack_one(own, "list_rebuilds", counters_.list_rebuilds);
  counters_.steps = first_step_ + done_;
  const auto all = kept_buffers(world_);
  for (const auto& [name, buffer] : without_ledger(all, options_.ledger))
    unpack_buffer(own, name, *workshop_, *buffer);
  unpack_path(own);
  started_ = true;
  settled_ = false;
}

void DeviceRun::begin_at(const Beginning& beginning) {
  first_step_ = counters_.steps = beginning.step;
  if (options_.orientation == OrientationUpdate::none || beginning.orientation.empty()) return;
  Bytes turned(image_.padded * decoder_->vector_bytes());
  for (std::size_t i = 0; i < image_.padded; ++i) {
    const Quaternion q = i < image_.particles ? beginning.orientation[i] : Quaternion::Identity();
    decoder_->put(turned, i, q.vec(), q.w());
  }
  workshop_->write(world_.orientations, turned);
}

void SmallRun::pack_path(Sections& own) {
  pack_buffer(own, "springs", *workshop_, world_.springs);
}

void SmallRun::unpack_path(const Sections& own) {
  unpack_buffer(own, "springs", *workshop_, world_.springs);
}

void ZonedRun::pack_path(Sections& own) {
  pack_one(own, "built_at_step", built_at_);
  pack_one(own, "lifetime", lifetime_);
  list_.pack_into(own);
}

void ZonedRun::unpack_path(const Sections& own) {
  unpack_one(own, "built_at_step", built_at_);
  unpack_one(own, "lifetime", lifetime_);
  list_.unpack_from(own);
  if (options_.remembers()) world_.springs = list_.springs();
  counters_.listed_pairs = list_.entries() / 2;
  enqueued_ = done();
}

void PairList::pack_into(Sections& own) const {
  const auto entries = static_cast<std::size_t>(entries_);
  pack_buffer(own, "list.starts", workshop_, now_.starts);
  pack_buffer(own, "list.partners", workshop_, now_.partners, entries * sizeof(cl_int));
  pack_buffer(own, "list.springs", workshop_, now_.springs, entries * memory_bytes_);
  pack_buffer(own, "list.built_at", workshop_, built_at_);
}

void PairList::unpack_from(const Sections& own) {
  Bytes partners, springs;
  unpack(own, "list.partners", partners);
  unpack(own, "list.springs", springs);
  entries_ = static_cast<std::int64_t>(partners.size() / sizeof(cl_int));
  if (springs.size() != partners.size() / sizeof(cl_int) * memory_bytes_)
    throw InputRefused("it was written by a run whose contacts remembered something else");
  make_room(entries_);
  unpack_buffer(own, "list.starts", workshop_, now_.starts);
  unpack_buffer(own, "list.built_at", workshop_, built_at_);
  if (!partners.empty()) workshop_.write(now_.partners, partners);
  if (!springs.empty()) workshop_.write(now_.springs, springs);
}

}  // namespace grainproof::opencl
