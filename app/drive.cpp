// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/drive.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include "model/errors.hpp"
#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

using Clock = std::chrono::steady_clock;

/// Longest run, in seconds, that is repeated to show the state before it went wrong.
constexpr double worth_repeating_s = 120.0;
/// Between two looks at the progress.
constexpr double look_every_s = 0.2;

double seconds_since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

/// Advances in pieces of about look_every_s, so that the progress can be shown in between.
class Stepper {
 public:
  Stepper(Run& run, std::int64_t last, Progress& progress) : run_(run), last_(last), progress_(progress) {}

  void advance_to(std::int64_t step) {
    while (done_ < step) {
      const std::int64_t piece = std::min(piece_, step - done_);
      const auto began = Clock::now();
      run_.advance(piece);
      run_.synchronise();
      done_ += piece;
      if (seconds_since(began) < look_every_s / 2.0 && piece == piece_) piece_ *= 2;
      progress_.show("step " + report::grouped(done_) + " of " + report::grouped(last_),
                     static_cast<double>(done_) / static_cast<double>(last_));
    }
  }

 private:
  Run& run_;
  std::int64_t last_;
  Progress& progress_;
  std::int64_t done_ = 0;
  std::int64_t piece_ = 64;
};

void give_last_good_frame(SteppingEngine& engine, const Scene& scene, const Outcome& outcome,
                          Observations& seen, const FrameSink& sink) {
  const std::int64_t step = outcome.step - 1;
  if (step < 0 || (!seen.frames.empty() && seen.frames.back().step >= step)) return;
  try {
    const auto run = engine.start(scene, {});
    run->advance(step);
    run->synchronise();
    seen.frames.assign(1, run->frame());
    sink(seen.frames.back(), nullptr);
  } catch (const RunWentWrong&) {
    // It went wrong before the step it named; the frames given so far are what there is.
  }
}

void step_through(SteppingEngine& engine, const Scene& scene, const Request& request, Progress& progress,
                  const FrameSink& sink, Observations& seen) {
  const auto steps = sample_steps(scene, request);
  const auto run = engine.start(scene, request);
  Stepper stepper(*run, steps.back(), progress);
  try {
    if (request.ledger) seen.initial_ledger = run->ledger();
    for (std::int64_t step : steps) {
      stepper.advance_to(step);
      seen.frames.assign(1, run->frame());
      if (request.ledger) seen.final_ledger = run->ledger();
      sink(seen.frames.back(), seen.final_ledger ? &*seen.final_ledger : nullptr);
    }
  } catch (const RunWentWrong& failure) {
    seen.outcome = {Outcome::Status::went_wrong, failure.what(), failure.step, failure.time,
                    failure.particles};
  }
  seen.counters = run->counters();
}

Observations drive_stepping(SteppingEngine& engine, const Scene& scene, const Request& request,
                            Progress& progress, const FrameSink& sink) {
  const auto began = Clock::now();
  Observations seen;
  seen.provenance = engine.provenance();
  progress.begin();
  step_through(engine, scene, request, progress, sink, seen);
  progress.clear();
  seen.wall_s = seconds_since(began);
  if (seen.outcome.status == Outcome::Status::went_wrong && seen.wall_s < worth_repeating_s)
    give_last_good_frame(engine, scene, seen.outcome, seen, sink);
  return seen;
}

}  // namespace

Observations drive(Engine& engine, const Scene& scene, const Request& request, Progress& progress,
                   const FrameSink& sink) {
  if (auto* stepping = dynamic_cast<SteppingEngine*>(&engine))
    return drive_stepping(*stepping, scene, request, progress, sink);
  Observations seen = engine.observe(scene, request);
  for (const Frame& frame : seen.frames) sink(frame, nullptr);
  if (seen.frames.size() > 1) seen.frames.erase(seen.frames.begin(), seen.frames.end() - 1);
  return seen;
}

}  // namespace grainproof::app
