// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/subject.hpp"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "app/engines.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

constexpr std::int64_t warm_up_steps = 8;
constexpr std::int64_t warm_up_size = 900;
constexpr std::int64_t fewest_steps = 8;
constexpr std::int64_t most_steps = 1000000;
constexpr std::int64_t lists_to_see = 3;

using Clock = std::chrono::steady_clock;

}  // namespace

double resident_bytes() {
  malloc_trim(0);  // what earlier subjects have given back must not look like room that costs nothing
  std::ifstream statistics("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  statistics >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Subject::Subject(std::string engine, MakeScene scene, std::int64_t particles, const Settings& settings,
                 Request request)
    : engine_name_(std::move(engine)),
      make_scene_(std::move(scene)),
      size_(particles),
      request_(std::move(request)),
      settings_(settings) {}

/// A small run of the same kind, so that compiling its kernels counts neither as time nor as memory.
void Subject::warm_up() {
  const auto run =
      dynamic_cast<SteppingEngine&>(*engine_).start(make_scene_(std::min(size_, warm_up_size)), request_);
  run->advance(warm_up_steps);
  run->synchronise();
}

void Subject::start() {
  engine_ = app::make_engine(engine_name_, {settings_.data, "", settings_.device});
  const Scene scene = make_scene_(size_);
  if (const Support support = engine_->supports(scene, request_); !support)
    throw InputRefused("unsupported: " + support.because);
  warm_up();
  particles_ = static_cast<double>(scene.particles.size());
  skin_ = scene.run.skin;
  const double before = resident_bytes();
  run_ = dynamic_cast<SteppingEngine&>(*engine_).start(scene, request_);
  timed_advance(warm_up_steps);
  const auto counted = static_cast<double>(run_->counters().device_bytes);
  bytes_per_particle_ = (counted > 0.0 ? counted : resident_bytes() - before) / particles_;
  choose_steps();
}

double Subject::timed_advance(std::int64_t steps) {
  const auto began = Clock::now();
  run_->advance(steps);
  run_->synchronise();
  return std::chrono::duration<double>(Clock::now() - began).count();
}

/// As many as fill the time asked for, by a trial that is long enough to be believed, and at least as many
/// as see a few lists rebuilt where that happens.
void Subject::choose_steps() {
  steps_ = fewest_steps;
  std::int64_t rebuilds = run_->counters().list_rebuilds;
  double spent = timed_advance(steps_);
  while (spent < 0.1 * settings_.seconds && steps_ < most_steps) {
    steps_ *= 4;
    rebuilds = run_->counters().list_rebuilds;
    spent = timed_advance(steps_);
  }
  rebuilds = run_->counters().list_rebuilds - rebuilds;
  const auto wanted = static_cast<std::int64_t>(static_cast<double>(steps_) * settings_.seconds / spent);
  const std::int64_t lists = rebuilds > 0 ? lists_to_see * steps_ / rebuilds : 0;
  steps_ = std::clamp(std::max(wanted, lists), fewest_steps, most_steps);
}

double Subject::step_seconds() {
  if (!run_) start();
  return timed_advance(steps_) / static_cast<double>(steps_);
}

void Subject::measure(benchmark::State& state) {
  try {
    if (!failure_.empty()) throw EngineFailed(failure_);
    if (!run_) start();
    const Counters before = run_->counters();
    double seconds = 0.0;
    for (auto _ : state) {
      seconds = timed_advance(steps_);
      state.SetIterationTime(seconds);
    }
    const Counters after = run_->counters();
    const auto steps = static_cast<double>(steps_);
    state.counters["particles"] = particles_;
    state.counters["steps"] = steps;
    state.counters["step_s"] = seconds / steps;
    state.counters["cundall_number"] = particles_ * steps / seconds;
    state.counters["rebuilds"] = static_cast<double>(after.list_rebuilds - before.list_rebuilds);
    state.counters["listed_pairs"] = static_cast<double>(after.listed_pairs) / particles_;
    if (++measured_ == settings_.rounds) run_.reset();
    if (skin_ >= 0.0) state.counters["skin_m"] = skin_;
    state.counters["bytes_per_particle"] = bytes_per_particle_;
  } catch (const std::exception& failure) {
    failure_ = failure.what();
    state.SkipWithError(failure_.c_str());
  }
}

std::string engine_key(const std::string& engine) {
  const std::size_t colon = engine.find(':');
  return "engine:" + engine.substr(0, colon) +
         "/precision:" + (colon == std::string::npos ? "double" : engine.substr(colon + 1));
}

void add_manual(const std::string& name, const std::function<void(benchmark::State&)>& measure) {
  benchmark::RegisterBenchmark(name.c_str(), measure)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kSecond);
}

void add_measurement(const std::string& name, const std::shared_ptr<Subject>& subject) {
  add_manual(name, [subject](benchmark::State& state) { subject->measure(state); });
}

}  // namespace grainproof::bench
