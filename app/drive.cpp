// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/drive.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

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
  Stepper(Run& run, std::int64_t last, bool ledger, RunKeeper* keeper, Progress& progress)
      : run_(run),
        first_(run.counters().steps),
        last_(last),
        ledger_(ledger),
        keeper_(keeper),
        progress_(progress) {}

  void advance_to(std::int64_t step) {
    while (done_ < step) {
      const std::int64_t stop = keeper_ ? std::min(step, keeper_->next_stop(done_)) : step;
      const std::int64_t piece = std::min(piece_, stop - done_);
      const auto began = Clock::now();
      run_.advance(piece);
      run_.synchronise();
      done_ += piece;
      const double seconds = seconds_since(began);
      if (seconds < look_every_s / 2.0 && piece == piece_) piece_ *= 2;
      if (keeper_) keeper_->pass(run_, seconds, ledger_);
      progress_.show("step " + report::grouped(done_) + " of " + report::grouped(last_),
                     static_cast<double>(done_ - first_) / static_cast<double>(last_ - first_));
    }
  }

 private:
  Run& run_;
  std::int64_t first_, last_;
  bool ledger_;
  RunKeeper* keeper_;
  Progress& progress_;
  std::int64_t done_ = first_;
  std::int64_t piece_ = 64;
};

/// What goes along with one drive.
struct Drive {
  SteppingEngine& engine;
  const Scene& scene;
  const Request& request;
  const DrivePlan& plan;
  const FrameSink& sink;
};

std::unique_ptr<Run> begun(const Drive& drive, const Checkpoint* from, const Request& request) {
  if (from == nullptr) return drive.engine.start(drive.scene, request);
  auto* restartable = dynamic_cast<RestartableEngine*>(&drive.engine);
  if (restartable == nullptr) throw InputRefused(drive.engine.name() + " cannot go on from a checkpoint");
  return restartable->resume(drive.scene, request, *from).run;
}

/// The steps of the frames still to come, and the one at which the run begins.
std::vector<std::int64_t> steps_from(const Scene& scene, const Request& request, std::int64_t first) {
  std::vector<std::int64_t> steps = sample_steps(scene, request);
  std::erase_if(steps, [&](std::int64_t step) { return step < first; });
  if (steps.empty() || steps.front() > first) steps.insert(steps.begin(), first);
  return steps;
}

/// Where a run that went wrong was still good: a frame, and a checkpoint for the keeper. It is found again
/// from the last checkpoint in memory, or by going through all of a run that was short.
void keep_last_good(const Drive& drive, Observations& seen) {
  RunKeeper* keeper = drive.plan.keeper;
  const bool looked = keeper && keeper->found_out();
  const std::int64_t step = looked ? keeper->last_good_step() : seen.outcome.step - 1;
  const bool remembered = keeper && keeper->good() && keeper->good()->state.step <= step;
  const Checkpoint* from = remembered ? &*keeper->good() : drive.plan.from;
  if (step < (from ? from->state.step : 0) || (!remembered && seen.wall_s > worth_repeating_s)) return;
  const bool shown = !seen.frames.empty() && seen.frames.back().step >= step;
  if (shown && !keeper) return;
  try {
    const auto run = begun(drive, from, keeper ? drive.request : Request{});
    run->advance(step - run->counters().steps);
    run->synchronise();
    if (!shown) {
      seen.frames.assign(1, run->frame());
      drive.sink(seen.frames.back(), nullptr);
    }
    if (!keeper) return;
    auto* restartable = dynamic_cast<RestartableRun*>(run.get());
    if (restartable == nullptr) return;
    if (const auto path = keeper->save_good(restartable->checkpoint()); !path.empty())
      seen.outcome.reason +=
          "; the last good state, of step " + std::to_string(step) + ", is kept in " + path.string();
  } catch (const RunWentWrong&) {
    // It went wrong before the step it named; the frames given so far are what there is.
  }
}

void step_through(const Drive& drive, Progress& progress, Driven& seen) {
  const bool ledger = drive.request.ledger;
  const auto run = begun(drive, drive.plan.from, drive.request);
  seen.first_step = run->counters().steps;
  const auto steps = steps_from(drive.scene, drive.request, seen.first_step);
  Stepper stepper(*run, steps.back(), ledger, drive.plan.keeper, progress);
  try {
    if (ledger) seen.initial_ledger = run->ledger();
    for (std::int64_t step : steps) {
      stepper.advance_to(step);
      seen.frames.assign(1, run->frame());
      if (ledger) seen.final_ledger = run->ledger();
      const Ledger* now = seen.final_ledger ? &*seen.final_ledger : nullptr;
      drive.sink(seen.frames.back(), now);
      if (drive.plan.keeper) drive.plan.keeper->see(seen.frames.back(), now);
    }
    seen.digest = run->digest();
  } catch (const RunWentWrong& failure) {
    seen.outcome = {Outcome::Status::went_wrong, failure.what(), failure.step, failure.time,
                    failure.particles};
  }
  seen.counters = run->counters();
}

Driven drive_stepping(const Drive& drive, Progress& progress) {
  const auto began = Clock::now();
  Driven seen;
  seen.provenance = drive.engine.provenance();
  progress.begin();
  step_through(drive, progress, seen);
  progress.clear();
  seen.wall_s = seconds_since(began);
  if (seen.outcome.status == Outcome::Status::went_wrong) keep_last_good(drive, seen);
  return seen;
}

}  // namespace

Driven drive(Engine& engine, const Scene& scene, const Request& request, Progress& progress,
             const FrameSink& sink, const DrivePlan& plan) {
  if (auto* stepping = dynamic_cast<SteppingEngine*>(&engine))
    return drive_stepping({*stepping, scene, request, plan, sink}, progress);
  if (plan.from)
    throw InputRefused(engine.name() + " does not go step by step, so it cannot go on from a checkpoint");
  Driven seen{engine.observe(scene, request)};
  for (const Frame& frame : seen.frames) sink(frame, nullptr);
  if (seen.frames.size() > 1) seen.frames.erase(seen.frames.begin(), seen.frames.end() - 1);
  return seen;
}

}  // namespace grainproof::app
