// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/cost_pair.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "app/engines.hpp"
#include "benchmarks/common/subject.hpp"
#include "model/errors.hpp"
#include "opencl/engine.hpp"

namespace grainproof::bench {
namespace {

constexpr std::int64_t fewest_steps = 8;
constexpr std::int64_t most_steps = 1000000;
/// Of a piece, where lists are rebuilt: the two need not rebuild at the same step.
constexpr std::int64_t lists_to_see = 3;
/// A small run of the same kind, so that compiling its kernels counts neither as time nor as memory.
constexpr std::int64_t warm_up_size = 900;

double process_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
PieceTime timed(const Work& work) {
  const auto began = std::chrono::steady_clock::now();
  const double used = process_seconds();
  work();
  const double cpu = process_seconds() - used;
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(), cpu};
}

std::unique_ptr<Engine> engine_of(const CostSide& side, const Settings& settings) {
  const std::size_t colon = side.engine.find(':');
  if (!side.zoned || !side.engine.starts_with("opencl"))
    return app::make_engine(side.engine, {settings.data, "", settings.device});
  opencl::EngineOptions options;
  options.precision = opencl::precision_named(side.engine.substr(colon + 1)).value();
  options.device = settings.device;
  options.kernels = settings.data / "kernels";
  options.path = opencl::Path::zoned;
  return std::make_unique<opencl::OpenClEngine>(options);
}

std::unique_ptr<Run> started(Engine& engine, const Scene& scene, const Request& request) {
  if (const Support support = engine.supports(scene, request); !support)
    throw InputRefused("unsupported: " + support.because);
  auto run = dynamic_cast<SteppingEngine&>(engine).start(scene, request);
  run->advance(fewest_steps);
  run->synchronise();
  return run;
}

app::KeeperOptions kept(bool sentinels) {
  app::KeeperOptions options;
  options.sentinels = sentinels;
  return options;
}

}  // namespace

KeptRun::KeptRun(const CostSide& side, std::int64_t particles, const Settings& settings)
    : scene_(side.scene(particles)),
      ledger_(side.ledger),
      sentinels_(side.sentinels),
      engine_(engine_of(side, settings)),
      keeper_(scene_, kept(side.sentinels), {}) {
  Request request;
  request.ledger = side.ledger;
  started(*engine_, side.scene(std::min(particles, warm_up_size)), request);
  const double before = resident_bytes();
  run_ = started(*engine_, scene_, request);
  const auto counted = static_cast<double>(run_->counters().device_bytes);
  bytes_per_particle_ = (counted > 0.0 ? counted : resident_bytes() - before) / this->particles();
}

/// A run looks once in many pieces; here each piece is followed by a look of which its share is counted, so
/// that few pieces tell of it, and of steps after it that find memory cold.
PieceTime KeptRun::look(double stepped_s) {
  const double wait_s = keeper_.wait_s();
  const PieceTime taken = timed([&] { keeper_.pass(*run_, wait_s, ledger_); });
  const double share = stepped_s / keeper_.wait_s();
  return {share * taken.wall_s, share * taken.cpu_s};
}

PieceTime KeptRun::advance(std::int64_t steps) {
  PieceTime spent = timed([&] {
    run_->advance(steps);
    run_->synchronise();
  });
  if (!sentinels_) return spent;
  const PieceTime looked = look(spent.wall_s);
  return {spent.wall_s + looked.wall_s, spent.cpu_s + looked.cpu_s};
}

CostPair::CostPair(CostSide without, CostSide with, std::int64_t particles, double bar,
                   const Settings& settings)
    : sides_{std::move(without), std::move(with)}, size_(particles), bar_(bar), settings_(settings) {}

void CostPair::start() {
  for (std::size_t i = 0; i < 2; ++i) runs_[i] = std::make_unique<KeptRun>(sides_[i], size_, settings_);
  choose_steps();
}

/// As many for both as take the cheaper one the time asked for, found by trials that are long enough to be
/// believed.
void CostPair::choose_steps() {
  steps_ = fewest_steps;
  double spent = 0.0;
  std::int64_t rebuilds = 0;
  while (true) {
    const std::int64_t before = runs_[0]->run().counters().list_rebuilds;
    spent = std::min(runs_[0]->advance(steps_).wall_s, runs_[1]->advance(steps_).wall_s);
    rebuilds = runs_[0]->run().counters().list_rebuilds - before;
    if (spent >= 0.2 * settings_.seconds || steps_ >= most_steps) break;
    steps_ *= 4;
  }
  const auto wanted = static_cast<std::int64_t>(static_cast<double>(steps_) * settings_.seconds / spent);
  const std::int64_t lists = rebuilds > 0 ? lists_to_see * steps_ / rebuilds : 0;
  steps_ = std::clamp(std::max(wanted, lists), fewest_steps, most_steps);
}

void CostPair::measure(benchmark::State& state, bool with) {
  try {
    if (!failure_.empty()) throw EngineFailed(failure_);
    if (!runs_[0]) start();
    KeptRun& kept = *runs_[with ? 1 : 0];
    PieceTime spent;
    for (auto _ : state) {
      spent = kept.advance(steps_);
      state.SetIterationTime(spent.wall_s);
    }
    const auto steps = static_cast<double>(steps_);
    state.counters["particles"] = kept.particles();
    state.counters["steps"] = steps;
    state.counters["step_s"] = spent.wall_s / steps;
    state.counters["cpu_step_s"] = spent.cpu_s / steps;
    state.counters["cundall_number"] = kept.particles() * steps / spent.wall_s;
    // What a process grows by can be room that was there before.
    if (kept.bytes_per_particle() > 0.0) state.counters["bytes_per_particle"] = kept.bytes_per_particle();
    state.counters["bar"] = bar_;
    if (++measured_ == 2 * settings_.rounds) runs_ = {};
  } catch (const std::exception& failure) {
    failure_ = failure.what();
    runs_ = {};
    state.SkipWithError(failure_.c_str());
  }
}

}  // namespace grainproof::bench
