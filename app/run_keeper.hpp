// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <filesystem>
#include <limits>
#include <optional>

#include "app/energy_sentinel.hpp"
#include "model/engine.hpp"
#include "report/checkpoint_file.hpp"

namespace grainproof::app {

/// What is asked of a keeper.
struct KeeperOptions {
  bool sentinels = true;
  std::int64_t every_steps = 0;  ///< a checkpoint is written so often; 0: not by steps
  double every_seconds = 0.0;    ///< of wall time; 0: not by time
  std::filesystem::path folder;  ///< where checkpoints are written; empty: nowhere
};

/// Goes along with a run: looks at its energy, keeps the last state that was found to be good, and writes
/// checkpoints. It costs a hundredth of the time of the steps: how long a look takes decides when the next
/// is.
class RunKeeper {
 public:
  RunKeeper(const Scene& scene, KeeperOptions options, report::CheckpointOrigin origin);

  /// The next boundary at which the run has to stop for a checkpoint.
  std::int64_t next_stop(std::int64_t step) const;
  /// A frame that is there anyway. Throws RunWentWrong.
  void see(const Frame& frame, const Ledger* ledger);
  /// Between pieces of a run, after `seconds` of steps. Throws RunWentWrong.
  void pass(Run& run, double seconds, bool ledger);

  /// Seconds of steps from one look to the next, as the last one took.
  double wait_s() const { return wait_s_; }

  /// The last state that was looked at and found good; none where there was none yet.
  const std::optional<Checkpoint>& good() const { return good_; }
  /// Whether the run went wrong by what the keeper saw; else the engine found out at the very step.
  bool found_out() const { return found_out_; }
  /// Of the last look.
  std::int64_t last_good_step() const { return energy_.last_good_step(); }
  /// Writes what was last good; returns where, empty where nothing is written.
  std::filesystem::path save_good(const Checkpoint& checkpoint) const;

 private:
  using Clock = std::chrono::steady_clock;
  void look(Run& run, bool ledger);
  void look(const Frame& frame, const Ledger* ledger);
  void write_due(Run& run);

  KeeperOptions options_;
  report::CheckpointOrigin origin_;
  EnergySentinel energy_;
  std::optional<Checkpoint> good_;
  bool found_out_ = false;
  double stepped_s_ = 0.0;  ///< since the last look
  double wait_s_;           ///< of steps before the next one
  Clock::time_point written_ = Clock::now();
};

/// "1000" is steps, "30s" seconds. Throws InputRefused.
void read_interval(const std::string& text, KeeperOptions& options);

}  // namespace grainproof::app
