// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "opencl/checkpoint.hpp"
#include "opencl/layout.hpp"
#include "opencl/world.hpp"

namespace grainproof::opencl {

/// What both paths share: the state on the device and how it is read back.
class DeviceRun : public RestorableRun {
 public:
  DeviceRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const BuildOptions& options,
            const ZoneGrid& grid, std::size_t work_group);

  void advance(std::int64_t steps) final;
  void synchronise() final;
  Frame frame() final;
  State state() final;
  std::uint64_t digest() final;
  Counters counters() const final { return counters_; }
  Ledger ledger() final;
  std::string maker() const final;
  Checkpoint checkpoint() final;
  void restore(const Sections& own) final;
  void begin_at(const Beginning& beginning) final;

 protected:
  /// Takes steps done_+1 … done_+steps, and before the first of all the forces of step 0.
  virtual void take_steps(std::int64_t steps) = 0;
  /// Waits for the device, tells of what went wrong, and leaves velocities at the boundary in `reported`.
  virtual void settle() = 0;
  /// What a path keeps besides the world, for a checkpoint.
  virtual void pack_path(Sections& own) = 0;
  virtual void unpack_path(const Sections& own) = 0;

  /// What changes with time by itself: the direction of gravity, the places of walls.
  void use_tables_of_steps(std::int64_t first, std::int64_t last);
  /// Throws RunWentWrong when a signal says so.
  void check_signals(std::span<const cl_int, signal_count> signals);
  /// Steps done since the start, as the device counts them.
  std::int64_t done() const { return done_; }
  /// From what the device holds: positions, and velocities at the step boundary.
  Frame frame_of(std::int64_t step, std::span<const std::byte> positions,
                 std::span<const std::byte> velocities, std::span<const std::byte> spins,
                 std::span<const std::byte> orientations) const;
  /// Of pairs, as the path keeps them, in any order.
  virtual std::vector<ContactMemory> pair_memories() = 0;
  /// Appends what the slot of particle i with particle j holds, where they touch and the other does not tell.
  void append_memory(std::vector<ContactMemory>& found, std::size_t i, std::size_t j,
                     std::span<const std::byte> memories, std::size_t slot) const;
  /// Memories of that many slots, as the scene's contacts start; `slot_of(i, j)` is that of particle i with
  /// j, nothing where i has none.
  Bytes remembered_pairs(
      std::size_t slots,
      const std::function<std::optional<std::size_t>(std::size_t, std::size_t)>& slot_of) const;

  std::shared_ptr<Workshop> workshop_;
  Scene scene_;
  BuildOptions options_;
  SceneImage image_;
  std::unique_ptr<Decoder> decoder_;
  World world_;
  Program& program_;
  Range particles_;
  Counters counters_;
  bool started_ = false;
  std::int64_t first_step_ = 0;  ///< that the device's step 0 is

 private:
  void ensure_started();
  /// By first and second; empty without history.
  std::vector<ContactMemory> memories();
  void append_wall_memories(std::vector<ContactMemory>& found);
  ContactMemory memory_at(std::span<const std::byte> memories, std::size_t slot,
                          const ContactLaws& laws) const;
  void put_memory(Bytes& memories, std::size_t slot, const ContactMemory& memory, double sign) const;
  void remember_walls();
  std::size_t index_of(std::int64_t id) const;
  Bytes read_particles(const cl::Buffer& buffer, std::size_t bytes_each);
  /// Nothing without rotation.
  Bytes read_spins(const cl::Buffer& buffer);
  /// Nothing where the scene does not ask for them.
  Bytes read_orientations();

  std::int64_t done_ = 0;
  bool settled_ = true;
  std::optional<std::chrono::steady_clock::time_point> stepping_since_;
};

}  // namespace grainproof::opencl
