// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cmath>

#include "model/engine.hpp"
#include "model/errors.hpp"

namespace grainproof {
std::int64_t step_at_or_after(double time, double step) {
  return static_cast<std::int64_t>(std::ceil(time / step - 1e-9));
}

std::vector<std::int64_t> sample_steps(const Scene& scene, const Request& request) {
  std::vector<std::int64_t> steps;
  if (request.every_step) {
    const std::int64_t last = step_at_or_after(scene.run.end, scene.run.step);
    for (std::int64_t n = 0; n <= last; ++n) steps.push_back(n);
    return steps;
  }
  const auto& times = request.times.empty() ? scene.run.sample_times : request.times;
  steps.push_back(0);
  for (double time : times) {
    const std::int64_t n = step_at_or_after(time, scene.run.step);
    if (n > steps.back()) steps.push_back(n);
  }
  return steps;
}

void Run::record(std::span<const std::int64_t> steps, std::vector<Frame>& frames) {
  std::int64_t done = counters().steps;
  for (const std::int64_t n : steps) {
    advance(n - done);
    synchronise();
    done = n;
    frames.push_back(frame());
  }
}

std::vector<Observations> Engine::observe_all(std::span<const Scene> scenes, const Request& request) {
  std::vector<Observations> all;
  all.reserve(scenes.size());
  for (const Scene& scene : scenes) all.push_back(observe(scene, request));
  return all;
}

Observations SteppingEngine::observe(const Scene& scene, const Request& request) {
  const auto began = std::chrono::steady_clock::now();
  Observations seen;
  seen.provenance = provenance();
  const std::unique_ptr<Run> run = start(scene, request);
  try {
    if (request.ledger) seen.initial_ledger = run->ledger();
    run->record(sample_steps(scene, request), seen.frames);
    if (request.ledger) seen.final_ledger = run->ledger();
  } catch (const RunWentWrong& failure) {
    seen.outcome = {Outcome::Status::went_wrong, failure.what(), failure.step, failure.time, failure.particles};
  }
  seen.counters = run->counters();
  seen.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return seen;
}

}  // namespace grainproof
