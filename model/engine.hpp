// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/observations.hpp"
#include "model/scene.hpp"
#include "model/state.hpp"

namespace grainproof {

/// What is asked of an engine besides the scene itself.
struct Request {
  std::vector<double> times;  ///< s; empty takes Scene::run.sample_times
  bool every_step = false;    ///< a frame at every step boundary; `times` is then ignored
  bool ledger = false;        ///< energy and impulse ledger
};

/// yes, or no because …
struct Support {
  bool yes = true;
  std::string because;

  static Support no(std::string reason) { return {false, std::move(reason)}; }
  explicit operator bool() const { return yes; }
};

/// Everything that can produce Observations of a Scene: an engine of ours, a closed form, a peer.
class Engine {
 public:
  virtual ~Engine() = default;

  /// As the command line spells it: "reference", "opencl:single", "analytic", "liggghts".
  virtual std::string name() const = 0;

  virtual Support supports(const Scene& scene, const Request& request) const = 0;

  /// The first frame is step 0. A run that goes wrong is an Outcome, not an exception;
  /// EngineFailed is thrown when the engine itself fails.
  virtual Observations observe(const Scene& scene, const Request& request) = 0;

  /// Many scenes of one case; an engine with a cost a start overrides this.
  virtual std::vector<Observations> observe_all(std::span<const Scene> scenes, const Request& request);
};

/// A run in progress of an engine that steps.
class Run {
 public:
  virtual ~Run() = default;

  /// Takes `steps` more steps; may return before the device has finished them. Throws RunWentWrong.
  virtual void advance(std::int64_t steps) = 0;
  /// Waits until every step asked for is done. Throws RunWentWrong.
  virtual void synchronise() = 0;
  /// Synchronised positions and velocities at the current step boundary.
  virtual Frame frame() = 0;
  /// Goes on to the last of `steps`, which increase, and appends the frame of each. A run that can write
  /// frames down on its way, without stopping for them, overrides this. Throws RunWentWrong, with the
  /// frames before it appended.
  virtual void record(std::span<const std::int64_t> steps, std::vector<Frame>& frames);
  /// The stored state, in id order.
  virtual State state() = 0;
  /// 64 bits over the stored state in id order; comparable within one engine and precision.
  virtual std::uint64_t digest() = 0;
  virtual Counters counters() const = 0;
  /// Zero unless the run was started with Request::ledger.
  virtual Ledger ledger() = 0;
};

/// An engine that advances a state step by step.
class SteppingEngine : public Engine {
 public:
  virtual std::unique_ptr<Run> start(const Scene& scene, const Request& request) = 0;
  virtual Provenance provenance() const = 0;

  /// Shared by all stepping engines: model/observe.cpp.
  Observations observe(const Scene& scene, const Request& request) override;
};

/// Index of the first step boundary at or after `time`, forgiving round-off of a billionth of a step.
std::int64_t step_at_or_after(double time, double step);

/// The steps whose frames a request asks for, increasing; the first is 0.
std::vector<std::int64_t> sample_steps(const Scene& scene, const Request& request);

}  // namespace grainproof
