// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/run.hpp"

#include "opencl/bytes.hpp"
#include "opencl/corrections.hpp"
#include "opencl/failure.hpp"
#include "opencl/read_ledger.hpp"
#include "opencl/wall_image.hpp"

namespace grainproof::opencl {
namespace {

/// FNV-1a over eight bytes at a time.
std::uint64_t hashed(std::uint64_t hash, std::span<const std::byte> bytes) {
  for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + i, 8);
    hash = (hash ^ word) * 0x100000001b3ull;
    hash ^= hash >> 29;
  }
  return hash;
}

}  // namespace

DeviceRun::DeviceRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const BuildOptions& options,
                     const ZoneGrid& grid, std::size_t work_group)
    : workshop_(std::move(workshop)),
      scene_(scene),
      options_(options),
      image_(make_image(scene, options.precision, grid, work_group)),
      decoder_(make_decoder(options.precision, scene.domain)),
      world_(make_world(*workshop_, image_, *decoder_, options)),
      program_(workshop_->program(options)),
      particles_{image_.padded, work_group} {
  remember_walls();
}

void DeviceRun::advance(std::int64_t steps) {
  if (steps <= 0) return;
  if (done_ + steps >= never) throw EngineFailed("a run of 2^31 steps or more is not supported");
  if (!stepping_since_) stepping_since_ = std::chrono::steady_clock::now();
  settled_ = false;
  take_steps(steps);
  started_ = true;
  done_ += steps;
  counters_.steps = first_step_ + done_;
}

void DeviceRun::synchronise() {
  if (settled_) return;
  settle();
  settled_ = true;
  if (stepping_since_) {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - *stepping_since_;
    counters_.step_loop_wall_s += wall.count();
    stepping_since_.reset();
  }
}

void DeviceRun::ensure_started() {
  if (!started_) {
    take_steps(0);
    started_ = true;
    settled_ = false;
  }
  synchronise();
}

Bytes DeviceRun::read_particles(const cl::Buffer& buffer, std::size_t bytes_each) {
  Bytes bytes(image_.particles * bytes_each);
  if (!bytes.empty()) workshop_->read(buffer, bytes);
  return bytes;
}

Bytes DeviceRun::read_spins(const cl::Buffer& buffer) {
  return scene_.rotation ? read_particles(buffer, decoder_->vector_bytes()) : Bytes{};
}

Bytes DeviceRun::read_orientations() {
  const bool kept = scene_.orientation != OrientationUpdate::none;
  return kept ? read_particles(world_.orientations, decoder_->vector_bytes()) : Bytes{};
}

Frame DeviceRun::frame() {
  synchronise();
  return frame_of(done_, read_particles(world_.positions, decoder_->position_bytes()),
                  read_particles(world_.reported, decoder_->vector_bytes()),
                  read_spins(world_.reported_spins), read_orientations());
}

Frame DeviceRun::frame_of(std::int64_t step, std::span<const std::byte> positions,
                          std::span<const std::byte> velocities, std::span<const std::byte> spins,
                          std::span<const std::byte> orientations) const {
  Frame frame;
  frame.step = first_step_ + step;
  frame.time = static_cast<double>(frame.step) * scene_.run.step;
  frame.position.reserve(image_.particles);
  frame.velocity.reserve(image_.particles);
  for (std::size_t i = 0; i < image_.particles; ++i) {
    frame.position.push_back(decoder_->position(positions, i));
    frame.velocity.push_back(decoder_->vector(velocities, i));
    if (scene_.rotation) frame.angular_velocity.push_back(decoder_->vector(spins, i));
    if (!orientations.empty()) frame.orientation.push_back(decoder_->quaternion(orientations, i));
  }
  return frame;
}

State DeviceRun::state() {
  const bool lags = scene_.run.integrator == Integrator::leapfrog_verlet && done_ > 0;
  const Frame now = frame();
  State state;
  state.step = now.step;
  state.time = now.time;
  for (const Particle& p : scene_.particles) state.ids.push_back(p.id);
  state.position = now.position;
  state.velocity = now.velocity;
  state.angular_velocity = now.angular_velocity;
  state.orientation = now.orientation;
  state.contacts = memories();
  state.velocity_lag = lags ? 0.5 : 0.0;
  if (lags) {
    const Bytes held = read_particles(world_.velocities, decoder_->vector_bytes());
    const Bytes turning = read_spins(world_.spins);
    for (std::size_t i = 0; i < image_.particles; ++i) {
      state.velocity[i] = decoder_->vector(held, i);
      if (scene_.rotation) state.angular_velocity[i] = decoder_->vector(turning, i);
    }
  }
  return state;
}

std::uint64_t DeviceRun::digest() {
  ensure_started();
  std::uint64_t hash = 0xcbf29ce484222325ull;
  hash = hashed(hash, read_particles(world_.positions, decoder_->position_bytes()));
  for (const cl::Buffer& vectors : {world_.velocities, world_.rests, world_.accelerations})
    hash = hashed(hash, read_particles(vectors, decoder_->vector_bytes()));
  if (options_.holds_middles()) {
    hash = hashed(hash, read_particles(world_.middles, decoder_->vector_bytes()));
    hash = hashed(hash, read_spins(world_.spin_middles));
  }
  for (const cl::Buffer& vectors : {world_.spins, world_.spin_rests, world_.angular_accelerations})
    hash = hashed(hash, read_spins(vectors));
  hash = hashed(hash, read_orientations());
  for (const ContactMemory& memory : memories()) {
    const std::array words{memory.first, memory.second};
    hash = hashed(hash, std::as_bytes(std::span(words)));
    hash = hashed(hash, std::as_bytes(std::span(&memory.overlap, 1)));
    for (const Vec3& spring : {memory.tangential_displacement, memory.rolling_torque})
      hash = hashed(hash, std::as_bytes(std::span(spring.data(), 3)));
  }
  return hash;
}

Ledger DeviceRun::ledger() {
  if (!options_.ledger) return {};
  ensure_started();
  const bool half_step_behind =
      done_ > 0 && (scene_.run.integrator == Integrator::leapfrog_verlet ||
                    scene_.run.integrator == Integrator::velocity_verlet || options_.holds_middles());
  const double pending = half_step_behind ? scene_.run.step / 2 : 0.0;
  const std::size_t slots = image_.near.count();
  const LedgerBytes bytes{
      read_particles(world_.tallies, decoder_->tally_bytes()),
      read_particles(world_.sums, decoder_->ledger_bytes()),
      read_particles(options_.holds_middles() ? world_.middles : world_.velocities, decoder_->vector_bytes()),
      read_spins(options_.holds_middles() ? world_.spin_middles : world_.spins),
      read_particles(world_.wall_tallies, slots * decoder_->wall_tally_bytes()),
      read_particles(world_.wall_sums, slots * decoder_->wall_sums_bytes()),
      options_.corrects() ? read_particles(world_.corrections, correction_words * decoder_->vector_bytes())
                          : Bytes{}};
  return read_ledger(scene_, image_.near, frame(), bytes, *decoder_, pending);
}

void DeviceRun::use_tables_of_steps(std::int64_t first, std::int64_t last) {
  world_.table_origin = static_cast<cl_int>(first);
  first += first_step_;
  last += first_step_;
  if (options_.gravity == GravityKind::rotating)
    world_.gravity_table =
        workshop_->upload(gravity_table(scene_.gravity, scene_.run.step, first, last, options_.precision));
  if (image_.near.moving() > 0)
    world_.stands = workshop_->upload(stand_table(image_.near, scene_, first, last, options_.precision));
}

void DeviceRun::check_signals(std::span<const cl_int, signal_count> signals) {
  const cl_int step = std::min(signals[escaped_at], signals[overlapped_at]);
  if (step == never) return;
  const Bytes faults = read_particles(world_.faults, sizeof(cl_int4));
  settled_ = true;
  throw_failure(scene_, step, faults, first_step_);
}

}  // namespace grainproof::opencl
