// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/dense_run.hpp"

#include <algorithm>
#include <cmath>

#include "model/errors.hpp"
#include "opencl/bytes.hpp"
#include "opencl/layout.hpp"

namespace grainproof::opencl {
namespace {

constexpr std::int64_t longest_batch = 1024;
constexpr std::int64_t shortest_batch = 4;
/// Work-items in a work-group: few of those that take many particles, and of those that take one as many as
/// keep a multiprocessor busy without asking for a large share of its registers.
Range items_for(std::size_t particles, const DenseOptions& options) {
  return {particles / static_cast<std::size_t>(lanes_of(options)), options.one ? 128u : 8u};
}

/// Stretches of a step on a CPU: so few that the cores' runtime hands them out at no cost, so many that a
/// core that is done early finds one of another's. kernels/dense_shares.cl
StepShares shares_of(Range items, const DenseOptions& options, const Workshop& workshop) {
  if (options.one) return {items, 1, 1};
  const std::size_t cores = workshop.compute_units(), most = 64 * cores;
  const std::size_t stretch = std::max<std::size_t>((items.items + most - 1) / most, 8);
  return {
      {(items.items + stretch - 1) / stretch, 1}, static_cast<cl_int>(cores), static_cast<cl_int>(stretch)};
}

cl_int earliest(const DenseSignals& signals, Signal signal) {
  return std::min(signals.of[0][signal], signals.of[1][signal]);
}

/// As kernels/dense_shares.cl lays them out.
Bytes no_claims(cl_int shares) {
  constexpr std::size_t line = 16;
  return Bytes(sizeof(cl_int) * 2 * line * static_cast<std::size_t>(shares));
}

DenseWorld make_dense_world(Workshop& workshop, const DenseImage& image, const DenseOptions& options) {
  DenseWorld w;
  w.box = workshop.upload(image.box);
  w.laws = workshop.upload(image.laws);
  w.planes = workshop.upload(image.planes);
  w.records = {workshop.upload(image.records), workshop.room(image.records.size())};
  w.kept = image.kept.empty() ? workshop.room(512) : workshop.upload(image.kept);
  w.built_at = workshop.upload(image.built_at);
  w.cells = workshop.upload(image.cells);
  std::vector<cl_int> ids(image.padded);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<cl_int>(i);
  w.ids = workshop.upload(bytes_of(ids));
  const auto groups = image.padded / static_cast<std::size_t>(group_size(options));
  w.heads = workshop.upload(Bytes(sizeof(cl_int4) * groups));
  for (cl::Buffer* empty : {&w.list, &w.springs, &w.marks}) *empty = workshop.room(64);
  return w;
}

}  // namespace

DenseRun::DenseRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const DenseOptions& options,
                   double skin, std::optional<double> searched_from)
    : workshop_(std::move(workshop)),
      scene_(scene),
      options_(options),
      grid_(scene, skin),
      image_(make_dense_image(scene, options_, grid_, window_size)),
      program_(&workshop_->program(options_)),
      items_(items_for(image_.padded, options)),
      shares_(shares_of(items_, options, *workshop_)),
      world_(make_dense_world(*workshop_, image_, options_)),
      list_(*workshop_, world_, image_, options_, grid_, 64),
      signals_(workshop_->room(sizeof(DenseSignals))),
      claims_(workshop_->upload(no_claims(shares_.count))),
      whose_(workshop_->upload(Bytes(sizeof(cl_int) * static_cast<std::size_t>(shares_.count)))) {
  image_.records = image_.kept = image_.built_at = {};
  if (searched_from) search_.emplace(2.0 * grid_.largest_radius, skin, *searched_from);
}

void DenseRun::advance(std::int64_t steps) {
  if (steps <= 0) return;
  if (done_ + steps >= never) throw EngineFailed("a run of 2^31 steps or more is not supported");
  if (!stepping_since_) stepping_since_ = std::chrono::steady_clock::now();
  settled_ = false;
  ensure_started();
  done_ += steps;
  enqueue_all();
  counters_.steps = first_step_ + done_;
}

void DenseRun::enqueue_all() {
  while (enqueued_ < done_) {
    if (trial_is_due()) try_another_skin();
    const std::int64_t last = std::min(done_, enqueued_ + next_batch());
    enqueue(enqueued_, last);
    enqueued_ = last;
    if (last < done_) caught_up();
  }
}

void DenseRun::ensure_started() {
  if (built_at_ < 0) build_list(0, 0);
}

void DenseRun::synchronise() {
  if (settled_) return;
  ensure_started();
  while (!caught_up()) enqueue_all();
  settled_ = true;
  if (stepping_since_) {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - *stepping_since_;
    counters_.step_loop_wall_s += wall.count();
    stepping_since_.reset();
  }
}

Counters DenseRun::counters() const {
  Counters counters = counters_;
  counters.device_bytes = static_cast<std::int64_t>(size_of(world_) + list_.bytes() + sizeof(DenseSignals));
  return counters;
}

DenseSignals DenseRun::read_signals() {
  DenseSignals signals;
  workshop_->read(signals_, std::as_writable_bytes(std::span(&signals, 1)));
  return signals;
}

void DenseRun::reset_signals(std::int64_t rows_taken) {
  DenseSignals signals;
  signals.rows_taken = static_cast<cl_int>(rows_taken);
  signals.row_room = static_cast<cl_int>(list_.row_room());
  workshop_->write(signals_, std::as_bytes(std::span(&signals, 1)));
  workshop_->write(claims_, no_claims(shares_.count));
}

void DenseRun::build_list(std::int64_t at, std::int64_t rows_taken) {
  list_.build(world_, *program_, static_cast<int>(at & 1), rows_taken);
  while (list_.crowded()) {
    options_.most_partners *= 2;
    program_ = &workshop_->program(options_);
    list_.build_again(world_, *program_, static_cast<int>(at & 1));
  }
  ++counters_.list_rebuilds;
  counters_.listed_pairs = list_.slots() * group_size(options_) / 2;
  counters_.skin = grid_.skin;
  built_at_ = at;
  reset_signals(list_.rows());
}

bool DenseRun::learn(std::int64_t age) {
  const double entries =
      static_cast<double>(list_.slots() * group_size(options_)) / static_cast<double>(image_.particles);
  if (!search_ || !search_->learn(entries, age)) return false;
  lifetime_ =
      std::max<std::int64_t>(std::llround(static_cast<double>(lifetime_) * search_->skin() / grid_.skin), 1);
  use_skin(search_->skin());
  return true;
}

void DenseRun::use_skin(double skin) {
  grid_ = DenseGrid(scene_, skin);
  workshop_->write(world_.box, make_dense_box(scene_, options_, grid_));
  list_.use_grid(world_, grid_);
}

bool DenseRun::trial_is_due() const {
  const std::int64_t age = enqueued_ - built_at_;
  return search_ && age > 0 && SkinSearch::next_trial(age - 1) == age;
}

void DenseRun::try_another_skin() {
  if (!caught_up() || !learn(enqueued_ - built_at_)) return;
  build_list(enqueued_, read_signals().rows_taken);
}

void DenseRun::enqueue(std::int64_t first, std::int64_t last) {
  for (std::int64_t n = first; n < last; ++n) {
    const auto at = static_cast<std::size_t>(n & 1);
    workshop_->launch(*program_, "dense_step", shares_.stretches, world_.box, world_.laws, world_.planes,
                      world_.records[at], world_.kept, world_.built_at, world_.cells, world_.heads,
                      world_.list, world_.springs, world_.springs, world_.marks, world_.marks,
                      world_.records[1 - at], signals_, claims_, whose_, shares_.count, shares_.stretch,
                      static_cast<cl_int>(items_.items), static_cast<cl_int>(n));
  }
}

bool DenseRun::caught_up() {
  const DenseSignals signals = read_signals();
  const cl_int escaped = earliest(signals, escaped_at), overlapped = earliest(signals, overlapped_at);
  if (std::min(escaped, overlapped) != never)
    tell_what_went_wrong(std::min(escaped, overlapped), escaped < overlapped);
  const std::int64_t stale = earliest(signals, stale_at);
  if (stale == never) return true;
  lifetime_ = std::max<std::int64_t>(stale - built_at_, 1);
  learn(lifetime_);
  build_list(stale, signals.rows_taken);
  enqueued_ = stale;
  return enqueued_ == done_;
}

/// Up to where the list is expected to go stale, and a little beyond; a list that outlives that is trusted
/// for as long again. With a search, never beyond where it is to be asked.
std::int64_t DenseRun::next_batch() const {
  const std::int64_t age = enqueued_ - built_at_;
  const std::int64_t expected = std::max(lifetime_, age) - age + std::max(lifetime_, age) / 8;
  const std::int64_t batch = std::clamp(age >= lifetime_ ? age : expected, shortest_batch, longest_batch);
  return search_ ? std::min(batch, SkinSearch::next_trial(age) - age) : batch;
}

}  // namespace grainproof::opencl
