// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/small_run.hpp"

#include <algorithm>
#include <bit>

#include "model/errors.hpp"
#include "opencl/bytes.hpp"

namespace grainproof::opencl {
namespace {

/// Bounds the table of a time-dependent field or of moving walls, and how long a device is kept from
/// answering.
constexpr std::int64_t steps_a_launch = 1 << 16;

/// Bounds the room for frames, at 4 kB a frame of 64 particles.
constexpr std::size_t frames_a_launch = 4096;

std::size_t group_for(const Scene& scene) {
  return std::bit_ceil(std::max<std::size_t>(scene.particles.size(), 1));
}

}  // namespace

SmallRun::SmallRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const BuildOptions& options)
    : DeviceRun(std::move(workshop), scene, options, ZoneGrid{}, group_for(scene)), none_(make_samples({})) {
  remember_pairs();
}

SmallRun::Samples SmallRun::make_samples(std::span<const std::int64_t> steps) {
  Samples s;
  s.steps.assign(steps.begin(), steps.end());
  const std::size_t entries = std::max<std::size_t>(steps.size(), 1) * image_.padded;
  s.steps_on_device = workshop_->upload(bytes_of(s.steps));
  s.positions = workshop_->room(entries * decoder_->position_bytes());
  s.velocities = workshop_->room(entries * decoder_->vector_bytes());
  const bool lying = options_.orientation != OrientationUpdate::none;
  s.spins = workshop_->room((options_.rotation ? entries : 1) * decoder_->vector_bytes());
  s.orientations = workshop_->room((lying ? entries : 1) * decoder_->vector_bytes());
  return s;
}

void SmallRun::take_steps(std::int64_t steps) {
  const std::int64_t end = done() + steps;
  const auto most = steps_a_launch / static_cast<std::int64_t>(1 + image_.near.moving());
  std::int64_t first = done();
  do {
    const std::int64_t last = std::min(end, first + most);
    use_tables_of_steps(first, last);
    const cl_int set_up = first == 0 && !started_ ? 1 : 0;
    const auto next = std::upper_bound(samples_->steps.begin(), samples_->steps.end(), first);
    launch_in_world(*workshop_, program_, "run_small", particles_, world_, set_up, static_cast<cl_int>(first),
                    static_cast<cl_int>(last), samples_->steps_on_device,
                    static_cast<cl_int>(samples_->steps.size()),
                    static_cast<cl_int>(next - samples_->steps.begin()), samples_->positions,
                    samples_->velocities, samples_->spins, samples_->orientations);
    first = last;
  } while (first < end);
}

void SmallRun::settle() {
  std::array<cl_int, signal_count> signals{};
  workshop_->read(world_.signals, std::as_writable_bytes(std::span(signals)));
  check_signals(signals);
}

std::vector<ContactMemory> SmallRun::pair_memories() {
  const std::size_t row = image_.padded;
  Bytes springs(row * row * memory_bytes(options_, *decoder_));
  workshop_->read(world_.springs, springs);
  std::vector<ContactMemory> found;
  for (std::size_t i = 0; i < image_.particles; ++i)
    for (std::size_t j = 0; j < image_.particles; ++j) append_memory(found, i, j, springs, i * row + j);
  return found;
}

void SmallRun::remember_pairs() {
  if (scene_.remembered.empty()) return;
  const std::size_t row = image_.padded;
  workshop_->write(world_.springs, remembered_pairs(row * row, [&](std::size_t i, std::size_t j) {
                     return std::optional<std::size_t>(i * row + j);
                   }));
}

void SmallRun::record(std::span<const std::int64_t> steps, std::vector<Frame>& frames) {
  std::vector<std::int64_t> counted(steps.begin(), steps.end());
  for (std::int64_t& step : counted) step -= first_step_;
  steps = counted;
  while (!steps.empty() && steps.front() <= done()) {
    frames.push_back(frame());
    steps = steps.subspan(1);
  }
  while (!steps.empty()) {
    const auto some = steps.first(std::min(frames_a_launch, steps.size()));
    record_some(some, frames);
    steps = steps.subspan(some.size());
  }
}

void SmallRun::record_some(std::span<const std::int64_t> steps, std::vector<Frame>& frames) {
  Samples samples = make_samples(steps);
  samples_ = &samples;
  advance(steps.back() - done());
  samples_ = &none_;
  const std::size_t entries = steps.size() * image_.padded;
  Bytes positions(entries * decoder_->position_bytes()), velocities(entries * decoder_->vector_bytes());
  Bytes spins(scene_.rotation ? velocities.size() : 0);
  Bytes orientations(scene_.orientation != OrientationUpdate::none ? velocities.size() : 0);
  workshop_->read_later(samples.positions, positions);
  if (scene_.rotation) workshop_->read_later(samples.spins, spins);
  if (!orientations.empty()) workshop_->read_later(samples.orientations, orientations);
  workshop_->read(samples.velocities, velocities);
  const auto part = [&](const Bytes& all, std::size_t k) {
    const std::size_t size = all.size() / steps.size();
    return std::span<const std::byte>(all).subspan(k * size, size);
  };
  const auto append_before = [&](std::int64_t end) {
    for (std::size_t k = 0; k < steps.size() && steps[k] < end; ++k)
      frames.push_back(
          frame_of(steps[k], part(positions, k), part(velocities, k), part(spins, k), part(orientations, k)));
  };
  try {
    synchronise();
  } catch (const RunWentWrong& failure) {
    append_before(failure.step - first_step_);
    throw;
  }
  append_before(never);
}

}  // namespace grainproof::opencl
