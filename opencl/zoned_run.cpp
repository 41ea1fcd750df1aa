// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/zoned_run.hpp"

#include <algorithm>
#include <array>

namespace grainproof::opencl {
namespace {

/// Few enough that a failure is heard of soon, and launches that find the list stale cost little.
constexpr std::int64_t longest_batch = 1024;
constexpr std::int64_t shortest_batch = 4;

}  // namespace

ZonedRun::ZonedRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const BuildOptions& options,
                   const ZoneGrid& grid, std::size_t work_group)
    : DeviceRun(std::move(workshop), scene, options, grid, work_group),
      list_(*workshop_, program_, image_, *decoder_, grid, work_group,
            options.remembers() ? memory_bytes(options, *decoder_) : 0) {}

void ZonedRun::take_steps(std::int64_t steps) {
  const std::int64_t target = done() + steps;
  if (enqueued_ < 0) {
    build_list(0);
    enqueued_ = 0;
  }
  while (enqueued_ < target) {
    const std::int64_t last = std::min(target, enqueued_ + next_batch());
    enqueue(enqueued_ + 1, last);
    enqueued_ = last;
    if (last < target) catch_up();
  }
}

void ZonedRun::settle() {
  catch_up();
  launch_in_world(*workshop_, program_, "report", particles_, world_, static_cast<cl_int>(enqueued_));
}

void ZonedRun::build_list(std::int64_t at_step) {
  list_.build(world_);
  if (at_step == 0 && !scene_.remembered.empty()) remember_pairs();
  if (options_.remembers()) world_.springs = list_.springs();
  ++counters_.list_rebuilds;
  counters_.listed_pairs = list_.entries() / 2;
  built_at_ = at_step;
  use_tables_of_steps(at_step, at_step);
  enqueue_forces(at_step);
}

void ZonedRun::enqueue_forces(std::int64_t at_step) {
  const auto step = static_cast<cl_int>(at_step);
  if (options_.implicit_dashpots()) {
    launch_in_world(*workshop_, program_, "resolve_springs", particles_, world_, list_.starts(),
                    list_.partners(), step);
    launch_in_world(*workshop_, program_, "foresee_velocities", particles_, world_, step);
  }
  launch_in_world(*workshop_, program_, "resolve", particles_, world_, list_.starts(), list_.partners(),
                  step);
}

void ZonedRun::enqueue(std::int64_t first, std::int64_t last) {
  use_tables_of_steps(first, last);
  for (std::int64_t n = first; n <= last; ++n) {
    const auto step = static_cast<cl_int>(n);
    launch_in_world(*workshop_, program_, "move", particles_, world_, list_.built_at(), step);
    enqueue_forces(n);
  }
}

void ZonedRun::catch_up() {
  std::array<cl_int, signal_count> signals{};
  while (true) {
    workshop_->read(world_.signals, std::as_writable_bytes(std::span(signals)));
    check_signals(signals);
    const std::int64_t stale = signals[stale_at];
    if (stale == never) return;
    lifetime_ = std::max<std::int64_t>(stale - built_at_, 1);
    signals[stale_at] = never;
    signals[halted] = 0;
    workshop_->write(world_.signals, std::as_bytes(std::span(signals)));
    build_list(stale);
    enqueue(stale + 1, enqueued_);
  }
}

std::vector<ContactMemory> ZonedRun::pair_memories() {
  std::vector<ContactMemory> found;
  const auto entries = static_cast<std::size_t>(list_.entries());
  if (entries == 0) return found;
  std::vector<cl_int> starts(image_.padded + 1), partners(entries);
  Bytes springs(entries * memory_bytes(options_, *decoder_));
  workshop_->read(list_.starts(), std::as_writable_bytes(std::span(starts)));
  workshop_->read(list_.partners(), std::as_writable_bytes(std::span(partners)));
  workshop_->read(list_.springs(), springs);
  for (std::size_t i = 0; i < image_.particles; ++i)
    for (auto k = static_cast<std::size_t>(starts[i]); k < static_cast<std::size_t>(starts[i + 1]); ++k)
      append_memory(found, i, static_cast<std::size_t>(partners[k]), springs, k);
  return found;
}

void ZonedRun::remember_pairs() {
  const auto entries = static_cast<std::size_t>(list_.entries());
  if (entries == 0) return;
  std::vector<cl_int> starts(image_.padded + 1), partners(entries);
  workshop_->read(list_.starts(), std::as_writable_bytes(std::span(starts)));
  workshop_->read(list_.partners(), std::as_writable_bytes(std::span(partners)));
  const auto slot_of = [&](std::size_t i, std::size_t j) -> std::optional<std::size_t> {
    const auto from = partners.begin() + starts[i], to = partners.begin() + starts[i + 1];
    const auto found = std::lower_bound(from, to, static_cast<cl_int>(j));
    if (found == to || *found != static_cast<cl_int>(j)) return std::nullopt;
    return static_cast<std::size_t>(found - partners.begin());
  };
  workshop_->write(list_.springs(), remembered_pairs(entries, slot_of));
}

/// Up to where the list is expected to go stale, and a little beyond; a list that outlives that is trusted
/// for as long again.
std::int64_t ZonedRun::next_batch() const {
  const std::int64_t age = enqueued_ - built_at_;
  const std::int64_t expected = std::max(lifetime_, age) - age + std::max(lifetime_, age) / 8;
  return std::clamp(age >= lifetime_ ? age : expected, shortest_batch, longest_batch);
}

}  // namespace grainproof::opencl
