// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_keeper.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/errors.hpp"

namespace grainproof::app {
namespace {

/// Of the time of the steps may go into looks.
constexpr double share_of_looks = 0.01;
/// Seconds a particle, until a look has been measured: too long rather than too short, or the first look
/// alone would take more than the share of a short run.
constexpr double look_of_one_s = 2e-6;

double wait_after(double look_s) {
  return std::max(1.0, look_s / share_of_looks);
}

double seconds_since(std::chrono::steady_clock::time_point began) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

}  // namespace

RunKeeper::RunKeeper(const Scene& scene, KeeperOptions options, report::CheckpointOrigin origin)
    : options_(std::move(options)),
      origin_(std::move(origin)),
      energy_(scene),
      wait_s_(wait_after(look_of_one_s * static_cast<double>(scene.particles.size()))) {}

std::int64_t RunKeeper::next_stop(std::int64_t step) const {
  if (options_.every_steps <= 0) return std::numeric_limits<std::int64_t>::max();
  return (step / options_.every_steps + 1) * options_.every_steps;
}

void RunKeeper::see(const Frame& frame, const Ledger* ledger) {
  if (options_.sentinels) look(frame, ledger);
}

void RunKeeper::look(const Frame& frame, const Ledger* ledger) {
  try {
    energy_.look(frame, ledger);
  } catch (const RunWentWrong&) {
    found_out_ = true;
    throw;
  }
}

void RunKeeper::pass(Run& run, double seconds, bool ledger) {
  stepped_s_ += seconds;
  if (options_.sentinels && stepped_s_ >= wait_s_) look(run, ledger);
  write_due(run);
}

void RunKeeper::look(Run& run, bool ledger) {
  const auto began = Clock::now();
  const Frame frame = run.frame();
  if (ledger) {
    const Ledger now = run.ledger();
    look(frame, &now);
  } else {
    look(frame, nullptr);
  }
  if (auto* restartable = dynamic_cast<RestartableRun*>(&run)) good_ = restartable->checkpoint();
  stepped_s_ = 0.0;
  wait_s_ = wait_after(seconds_since(began));
}

void RunKeeper::write_due(Run& run) {
  if (options_.folder.empty()) return;
  const std::int64_t step = run.counters().steps;
  const bool by_steps = options_.every_steps > 0 && step % options_.every_steps == 0;
  const bool by_time = options_.every_seconds > 0.0 && seconds_since(written_) >= options_.every_seconds;
  if (!by_steps && !by_time) return;
  auto* restartable = dynamic_cast<RestartableRun*>(&run);
  if (restartable == nullptr) throw EngineFailed("this engine writes no checkpoints");
  report::write_checkpoint(options_.folder / "checkpoint.h5", {origin_, restartable->checkpoint()});
  written_ = Clock::now();
}

std::filesystem::path RunKeeper::save_good(const Checkpoint& checkpoint) const {
  if (options_.folder.empty()) return {};
  const auto path = options_.folder / "last_good.h5";
  report::write_checkpoint(path, {origin_, checkpoint});
  return path;
}

void read_interval(const std::string& text, KeeperOptions& options) {
  std::size_t read = 0;
  double value = 0.0;
  try {
    value = std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  const std::string unit = text.substr(read);
  const bool steps = unit.empty() && value >= 1.0 && value < 1e15 && std::floor(value) == value;
  if (read == 0 || !(steps || (unit == "s" && value > 0.0 && std::isfinite(value))))
    throw InputRefused("found --checkpoint-every " + text +
                       "; expected a number of steps such as 1000, or of seconds such as 30s");
  if (steps)
    options.every_steps = static_cast<std::int64_t>(value);
  else
    options.every_seconds = value;
}

}  // namespace grainproof::app
