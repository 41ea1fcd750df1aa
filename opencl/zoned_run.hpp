// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "opencl/pair_list.hpp"
#include "opencl/run.hpp"

namespace grainproof::opencl {

/// A scene of any size: two launches a step, a list of pairs that lasts until something has moved half the
/// skin.
///
/// Steps are enqueued in batches without asking the device. When the list has gone stale on the way, the
/// kernels stop by themselves; the host finds out at the end of the batch, builds a new list and goes on from
/// there.
class ZonedRun : public DeviceRun {
 public:
  ZonedRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const BuildOptions& options,
           const ZoneGrid& grid, std::size_t work_group);

 protected:
  void take_steps(std::int64_t steps) override;
  void settle() override;
  std::vector<ContactMemory> pair_memories() override;
  void pack_path(Sections& own) override;
  void unpack_path(const Sections& own) override;

 private:
  void build_list(std::int64_t at_step);
  void remember_pairs();
  void enqueue(std::int64_t first, std::int64_t last);
  /// Those at the boundary after a step.
  void enqueue_forces(std::int64_t at_step);
  void catch_up();
  std::int64_t next_batch() const;

  PairList list_;
  std::int64_t enqueued_ = -1;  ///< last step asked of the device; −1 before the first list
  std::int64_t built_at_ = 0;
  std::int64_t lifetime_ = 32;  ///< steps that the last list lasted
};

}  // namespace grainproof::opencl
