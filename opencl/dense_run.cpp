// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/dense_run.hpp"

#include <algorithm>

#include "model/errors.hpp"
#include "opencl/bytes.hpp"
#include "opencl/layout.hpp"

namespace grainproof::opencl {
namespace {

constexpr std::int64_t longest_batch = 1024;
constexpr std::int64_t shortest_batch = 4;
/// Groups a work-item, in work-groups of this many items.
constexpr std::size_t items_a_group = 8;

using Signals = std::array<std::array<cl_int, signal_count>, 2>;
constexpr Signals no_signals{{{never, never, never, 0}, {never, never, never, 0}}};

cl_int earliest(const Signals& signals, Signal signal) {
  return std::min(signals[0][signal], signals[1][signal]);
}

DenseWorld make_dense_world(Workshop& workshop, const DenseImage& image, const DenseOptions& options) {
  DenseWorld w;
  w.box = workshop.upload(image.box);
  w.laws = workshop.upload(image.laws);
  w.planes = workshop.upload(image.planes);
  w.records = {workshop.upload(image.records), workshop.room(image.records.size())};
  w.kept = workshop.upload(image.kept);
  w.built_at = workshop.upload(image.built_at);
  w.cells = workshop.upload(image.cells);
  std::vector<cl_int> ids(image.padded);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<cl_int>(i);
  w.ids = workshop.upload(bytes_of(ids));
  const auto groups = image.padded / static_cast<std::size_t>(group_size(options.precision));
  w.heads = workshop.upload(Bytes(sizeof(cl_int4) * groups));
  for (cl::Buffer* empty : {&w.list, &w.springs, &w.strained}) *empty = workshop.room(64);
  return w;
}

}  // namespace

DenseRun::DenseRun(std::shared_ptr<Workshop> workshop, const Scene& scene, Precision precision, double skin)
    : workshop_(std::move(workshop)),
      scene_(scene),
      options_(dense_options(scene, precision)),
      grid_(scene, skin),
      image_(make_dense_image(scene, options_, grid_, window_size)),
      program_(&workshop_->program(options_)),
      items_{image_.padded / static_cast<std::size_t>(group_size(precision)), items_a_group},
      world_(make_dense_world(*workshop_, image_, options_)),
      list_(*workshop_, image_, options_, grid_, 64),
      signals_(workshop_->room(sizeof(Signals))) {
  workshop_->write(signals_, std::as_bytes(std::span(no_signals)));
  image_.records = image_.kept = image_.built_at = {};
}

void DenseRun::advance(std::int64_t steps) {
  if (steps <= 0) return;
  if (done_ + steps >= never) throw EngineFailed("a run of 2^31 steps or more is not supported");
  if (!stepping_since_) stepping_since_ = std::chrono::steady_clock::now();
  settled_ = false;
  ensure_started();
  done_ += steps;
  while (enqueued_ < done_) {
    const std::int64_t last = std::min(done_, enqueued_ + next_batch());
    enqueue(enqueued_, last);
    enqueued_ = last;
    if (last < done_) catch_up();
  }
  counters_.steps = first_step_ + done_;
}

void DenseRun::ensure_started() {
  if (built_at_ < 0) build_list();
}

void DenseRun::synchronise() {
  if (settled_) return;
  ensure_started();
  catch_up();
  settled_ = true;
  if (stepping_since_) {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - *stepping_since_;
    counters_.step_loop_wall_s += wall.count();
    stepping_since_.reset();
  }
}

void DenseRun::build_list() {
  const std::int64_t at = built_at_ < 0 ? 0 : built_at_ + lifetime_;
  list_.build(world_, *program_, static_cast<int>(at & 1));
  while (list_.crowded()) {
    options_.most_partners *= 2;
    program_ = &workshop_->program(options_);
    list_.build_again(world_, *program_, static_cast<int>(at & 1));
  }
  ++counters_.list_rebuilds;
  counters_.listed_pairs = list_.slots() * group_size(options_.precision) / 2;
  built_at_ = at;
}

void DenseRun::enqueue(std::int64_t first, std::int64_t last) {
  for (std::int64_t n = first; n < last; ++n) {
    const auto at = static_cast<std::size_t>(n & 1);
    workshop_->launch(*program_, "dense_step", items_, world_.box, world_.laws, world_.planes,
                      world_.records[at], world_.kept, world_.built_at, world_.cells, world_.heads,
                      world_.list, world_.springs, world_.springs, world_.strained, world_.strained,
                      world_.records[1 - at], signals_, static_cast<cl_int>(n));
  }
}

void DenseRun::catch_up() {
  while (true) {
    Signals signals;
    workshop_->read(signals_, std::as_writable_bytes(std::span(signals)));
    const cl_int escaped = earliest(signals, escaped_at), overlapped = earliest(signals, overlapped_at);
    if (std::min(escaped, overlapped) != never)
      tell_what_went_wrong(std::min(escaped, overlapped), escaped < overlapped);
    const std::int64_t stale = earliest(signals, stale_at);
    if (stale == never) return;
    lifetime_ = std::max<std::int64_t>(stale - built_at_, 1);
    workshop_->write(signals_, std::as_bytes(std::span(no_signals)));
    build_list();
    enqueue(stale, enqueued_);
  }
}

/// Up to where the list is expected to go stale, and a little beyond; a list that outlives that is trusted
/// for as long again.
std::int64_t DenseRun::next_batch() const {
  const std::int64_t age = enqueued_ - built_at_;
  const std::int64_t expected = std::max(lifetime_, age) - age + std::max(lifetime_, age) / 8;
  return std::clamp(age >= lifetime_ ? age : expected, shortest_batch, longest_batch);
}

}  // namespace grainproof::opencl
