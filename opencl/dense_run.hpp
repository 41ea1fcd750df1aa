// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <memory>
#include <optional>

#include "opencl/checkpoint.hpp"
#include "opencl/dense_list.hpp"
#include "opencl/layout.hpp"
#include "opencl/skin_search.hpp"

namespace grainproof::opencl {

/// Of even and of odd boundaries; then how rows of springs are used, kernels/dense_springs.cl.
struct DenseSignals {
  std::array<std::array<cl_int, signal_count>, 2> of{{{never, never, never, 0}, {never, never, never, 0}}};
  cl_int rows_taken = 0, row_room = 0;
};

/// How a step is dealt out: `stretches` of as many items as one has, in as many shares as there are cores.
struct StepShares {
  Range stretches;
  cl_int count, stretch;
};

/// The list, read back.
struct DenseLists {
  std::vector<cl_int4> heads;  ///< of a group: first slot, slots, walls near, slots of walls
  std::vector<cl_int> entries;
  std::vector<cl_int> ids;
};

/// Many spheres with one kind of contact: one launch a step, particles in order of zones, groups of them at
/// once.
///
/// As in ZonedRun, steps are enqueued in batches without asking the device; kernels stop by themselves where
/// the list has gone stale, and the host goes on from there with a new one.
class DenseRun : public RestorableRun {
 public:
  /// With `searched_from` the skin is but the first, for others from there on to be tried.
  DenseRun(std::shared_ptr<Workshop> workshop, const Scene& scene, const DenseOptions& options, double skin,
           std::optional<double> searched_from);

  void advance(std::int64_t steps) override;
  void synchronise() override;
  Frame frame() override;
  State state() override;
  std::uint64_t digest() override;
  Counters counters() const override;
  Ledger ledger() override { return {}; }
  std::string maker() const override;
  Checkpoint checkpoint() override;
  void restore(const Sections& own) override;
  void begin_at(const Beginning& beginning) override;

 private:
  /// Before step `at`. `rows_taken`: DenseList::build.
  void build_list(std::int64_t at, std::int64_t rows_taken);
  DenseSignals read_signals();
  void reset_signals(std::int64_t rows_taken);
  void use_skin(double skin);
  void enqueue(std::int64_t first, std::int64_t last);
  void enqueue_all();
  /// Whether every step enqueued is taken; else there is a new list, and those after it are not enqueued.
  bool caught_up();
  /// Lets the search know what the list was like, and does as it says. Whether there is another skin.
  bool learn(std::int64_t age);
  bool trial_is_due() const;
  void try_another_skin();
  std::int64_t next_batch() const;
  void ensure_started();
  /// What is seen at the current boundary goes to the spare records; with `keeps`, springs and marks to
  /// others of the same size.
  const cl::Buffer& report(const cl::Buffer& springs, const cl::Buffer& marks, bool keeps);
  DenseRecords read_records(const cl::Buffer& records);
  /// In the order of the scene.
  std::vector<DenseBody> bodies(const cl::Buffer& records);
  DenseLists read_lists();
  std::vector<ContactMemory> memories();
  std::size_t group() const { return static_cast<std::size_t>(group_size(options_)); }
  [[noreturn]] void tell_what_went_wrong(cl_int step, bool escaped);

  std::shared_ptr<Workshop> workshop_;
  Scene scene_;
  DenseOptions options_;
  DenseGrid grid_;
  DenseImage image_;
  Program* program_;
  Range items_;
  StepShares shares_;
  DenseWorld world_;
  DenseList list_;
  cl::Buffer signals_;
  cl::Buffer claims_, whose_;  ///< kernels/dense_shares.cl
  std::optional<SkinSearch> search_;
  Counters counters_;
  std::int64_t first_step_ = 0;  ///< that the device's step 0 is
  std::int64_t done_ = 0;
  std::int64_t enqueued_ = 0;
  std::int64_t built_at_ = -1;
  std::int64_t lifetime_ = 32;
  bool settled_ = false;
  std::optional<std::chrono::steady_clock::time_point> stepping_since_;
};

}  // namespace grainproof::opencl
