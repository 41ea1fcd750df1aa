// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>

#include "app/progress.hpp"
#include "app/run_keeper.hpp"
#include "model/engine.hpp"

namespace grainproof::app {

/// The ledger at the frame's time; null where none is kept, and of frames that are found again.
using FrameSink = std::function<void(const Frame&, const Ledger*)>;

/// What goes along with a drive besides the scene; nothing of it has to be there.
struct DrivePlan {
  const Checkpoint* from = nullptr;  ///< to go on from
  RunKeeper* keeper = nullptr;
};

/// What was seen, and where an engine steps also:
struct Driven : Observations {
  std::int64_t first_step = 0;               ///< not 0 where the run went on from a checkpoint
  std::optional<std::uint64_t> digest = {};  ///< of the last state
};

/// Observes a scene and gives each frame to `sink` as it comes; the observations hold no frame but the
/// last. An engine that steps shows its progress. When such a run goes wrong, the last good state is found
/// again where that does not take long, is given to `sink`, and kept by the keeper.
Driven drive(Engine& engine, const Scene& scene, const Request& request, Progress& progress,
             const FrameSink& sink, const DrivePlan& plan = {});

}  // namespace grainproof::app
