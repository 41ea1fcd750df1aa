// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/long_run.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/scene_identity.hpp"
#include "model/errors.hpp"
#include "report/checkpoint_file.hpp"
#include "report/files.hpp"

namespace grainproof::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

json as_json(const LongHistory& history, const std::string& stamp) {
  json windows = json::array();
  for (const Window& window : history.windows)
    windows.push_back({{"step", window.step}, {"mean", window.mean}, {"most", window.most}});
  return {{"stamp", stamp},           {"windows", windows},
          {"failed", history.failed}, {"failed_at", history.failed_at},
          {"wall_s", history.wall_s}, {"complete", history.complete}};
}

LongHistory from_json(const json& kept) {
  LongHistory history{{}, kept.at("failed"), kept.at("failed_at"), kept.at("wall_s"), kept.at("complete")};
  for (const json& window : kept.at("windows"))
    history.windows.push_back(
        {window.at("step"), window.at("mean").get<Seen>(), window.at("most").get<Seen>()});
  return history;
}

/// One run with its place on the disk.
class LongRun {
 public:
  LongRun(RestartableEngine& engine, const LongPlan& plan, const LongPlace& place)
      : engine_(engine),
        plan_(plan),
        place_(place),
        origin_{plan.name, app::fingerprints_of(plan.scene), engine.provenance()} {}

  LongHistory go(const LongTick& tick) {
    if (load(); history_.complete) return history_;
    begin();
    try {
      for (auto w = static_cast<int>(history_.windows.size()); w < plan_.windows; ++w) {
        look_at(w);
        const bool on = tick(history_.windows.back().step);
        if (w + 1 < plan_.windows && (!on || seconds_since(written_) > place_.checkpoint_seconds)) write();
        if (!on) return history_;
      }
    } catch (const RunWentWrong& failure) {
      history_.failed = failure.what();
      history_.failed_at = failure.step;
    }
    history_.complete = true;
    write_history();
    return history_;
  }

 private:
  fs::path windows_file() const { return place_.folder / "windows.json"; }
  fs::path checkpoint_file() const { return place_.folder / "checkpoint.h5"; }

  void load() {
    std::ifstream file(windows_file());
    const json kept = json::parse(file, nullptr, false);
    if (kept.is_object() && kept.value("stamp", "") == place_.stamp) history_ = from_json(kept);
  }

  /// What was seen after the last checkpoint is seen again.
  void begin() {
    try {
      if (history_.windows.empty()) throw InputRefused("nothing was seen before");
      const auto saved = report::read_checkpoint(checkpoint_file());
      report::require_same_scene(checkpoint_file(), saved.origin, plan_.name, origin_.parts);
      const std::int64_t step = saved.checkpoint.state.step;
      std::erase_if(history_.windows, [&](const Window& window) { return window.step > step; });
      if (history_.windows.empty() || history_.windows.back().step != step)
        throw InputRefused("the checkpoint is of another step");
      run_ = engine_.resume(plan_.scene, {}, saved.checkpoint).run;
      std::cout << "note: " << plan_.name << " goes on from step " << step << std::endl;
    } catch (const InputRefused&) {
      history_ = {};
      run_.reset(dynamic_cast<RestartableRun*>(engine_.start(plan_.scene, {}).release()));
    }
  }

  std::vector<std::int64_t> steps_of(int window) const {
    const std::int64_t first = plan_.steps * window / plan_.windows;
    const std::int64_t last = plan_.steps * (window + 1) / plan_.windows;
    std::vector<std::int64_t> steps;
    for (int n = plan_.frames; n > 0; --n)
      steps.push_back(plan_.in_a_row ? last - n + 1 : last - (last - first) * (n - 1) / plan_.frames);
    return steps;
  }

  void look_at(int window) {
    const auto began = Clock::now();
    const std::vector<std::int64_t> steps = steps_of(window);
    std::vector<Frame> frames;
    run_->record(steps, frames);
    Window now{steps.back(), {}, {}};
    for (const Frame& frame : frames) {
      const Seen one = seen(plan_, frame);
      for (std::size_t i = 0; i < looks; ++i) {
        now.mean[i] += one[i] / static_cast<double>(frames.size());
        now.most[i] = std::max(now.most[i], one[i]);
      }
    }
    history_.windows.push_back(now);
    history_.wall_s += seconds_since(began);
  }

  /// Under a name of its own first, so that it is there as a whole or not at all.
  void write_history() const {
    const fs::path unfinished = windows_file().string() + ".new";
    report::write_file(unfinished, as_json(history_, place_.stamp).dump());
    fs::rename(unfinished, windows_file());
  }

  /// The checkpoint last: what was seen may reach beyond it, but never end before it.
  void write() {
    write_history();
    report::write_checkpoint(checkpoint_file(), {origin_, run_->checkpoint()});
    written_ = Clock::now();
  }

  RestartableEngine& engine_;
  const LongPlan& plan_;
  const LongPlace& place_;
  report::CheckpointOrigin origin_;
  LongHistory history_;
  std::unique_ptr<RestartableRun> run_;
  Clock::time_point written_ = Clock::now();
};

}  // namespace

LongHistory long_run(RestartableEngine& engine, const LongPlan& plan, const LongPlace& place,
                     const LongTick& tick) {
  return LongRun(engine, plan, place).go(tick);
}

std::string program_stamp(const fs::path& kernels) {
  const auto made = [](const fs::path& file) { return fs::last_write_time(file).time_since_epoch().count(); };
  auto newest = made(fs::read_symlink("/proc/self/exe"));
  if (fs::is_directory(kernels))
    for (const fs::directory_entry& entry : fs::directory_iterator(kernels))
      newest = std::max(newest, made(entry.path()));
  return std::to_string(newest);
}

}  // namespace grainproof::bench
