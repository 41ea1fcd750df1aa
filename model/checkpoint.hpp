// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/engine.hpp"
#include "model/sections.hpp"
#include "model/state.hpp"

namespace grainproof {

/// A run at a step boundary, to go on from: what any engine understands, and what the one that wrote it needs
/// to go on with the very same bits.
struct Checkpoint {
  State state;                        ///< velocities at the boundary itself: `velocity_lag` is 0
  std::optional<Ledger> ledger = {};  ///< so far; none where none is kept
  std::string maker = {};             ///< who can read `own`: engine, precision, path; empty: nobody
  Sections own = {};                  ///< sort order, lists, remainders, …
};

/// A run that can be stopped and gone on from.
class RestartableRun : public Run {
 public:
  /// Of the current step boundary.
  virtual Checkpoint checkpoint() = 0;

 protected:
  /// What any engine understands: state(), with the velocities at the boundary.
  Checkpoint portable();
};

/// A run that goes on from a checkpoint.
struct Resumed {
  std::unique_ptr<RestartableRun> run;
  std::string not_exact_because = {};  ///< empty: with the same bits as if it had never stopped
};

/// Where a run begins that goes on without the bits of the one before; its scene is as it stood there.
struct Beginning {
  std::int64_t step = 0;                     ///< the number of the first boundary
  std::vector<Quaternion> orientation = {};  ///< a particle each; empty: as drawn
};

/// A stepping engine whose runs are all RestartableRuns.
class RestartableEngine : public SteppingEngine {
 public:
  /// Goes on from a checkpoint of `scene`: with the bits of the run that made it where this engine made it
  /// the same way, else from what any engine understands. Throws InputRefused.
  Resumed resume(const Scene& scene, const Request& request, const Checkpoint& from);

 protected:
  /// With the bits of the run before; null, and `because` says why, where that cannot be.
  virtual std::unique_ptr<RestartableRun> restored(const Scene& scene, const Request& request,
                                                   const Checkpoint& from, std::string& because) = 0;
  /// A scene that is supported, but for where its particles are and what contacts remember: that was so in a
  /// run, walls in motion included.
  virtual std::unique_ptr<RestartableRun> go_on(const Scene& scene, const Request& request,
                                                const Beginning& beginning) = 0;
};

}  // namespace grainproof
