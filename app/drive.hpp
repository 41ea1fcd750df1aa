// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "app/progress.hpp"
#include "model/engine.hpp"

namespace grainproof::app {

/// The ledger at the frame's time; null where none is kept, and of frames that are found again.
using FrameSink = std::function<void(const Frame&, const Ledger*)>;

/// Observes a scene and gives each frame to `sink` as it comes; the observations hold no frame but the
/// last. An engine that steps shows its progress. When such a run goes wrong early enough, the last good
/// state is found again by repeating it up to the step before, and is given to `sink` too.
Observations drive(Engine& engine, const Scene& scene, const Request& request, Progress& progress,
                   const FrameSink& sink);

}  // namespace grainproof::app
