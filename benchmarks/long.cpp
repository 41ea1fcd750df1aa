// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

#include "app/engines.hpp"
#include "benchmarks/common/long_verdicts.hpp"
#include "benchmarks/common/subject.hpp"
#include "model/errors.hpp"
#include "report/numbers.hpp"

namespace grainproof::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double notes_every_s = 30.0;
constexpr std::size_t points_of_a_curve = 20;

/// About how long a run takes against the others: every body costs, and every step of a device.
double weight_of(const std::string& scene, double steps) {
  return steps * (scene == "bounces" ? 4.0 : scene == "pile" ? 60.0 : 1000.0);
}

double steps_of(const std::string& scene, bool quick) {
  return (scene == "bounces" ? 3.3e7 : scene == "pile" ? 1e7 : 1e6) / (quick ? 100.0 : 1.0);
}

/// All runs of this program, so that it can tell how much is left of them.
struct Budget {
  double planned = 0.0, done = 0.0, first_done = -1.0;
  Clock::time_point began, told;
  std::size_t runs = 0, finished = 0;

  void tell(const std::string& who, double now) {
    if (first_done < 0.0) {
      first_done = now;
      began = told = Clock::now();
    }
    if (std::chrono::duration<double>(Clock::now() - told).count() < notes_every_s) return;
    told = Clock::now();
    const double spent = std::chrono::duration<double>(told - began).count();
    const double left = spent * (planned - now) / std::max(now - first_done, 1e-9 * planned);
    std::cout << "note: long: " << who << ", " << std::lround(100.0 * now / planned) << " % of all, "
              << report::duration(left) << " to go" << std::endl;
  }
};

/// One scene on one engine with one integrator: run when its first quantity is asked for.
class LongSubject {
 public:
  LongSubject(const Settings& settings, std::shared_ptr<Budget> budget, std::string scene, std::string engine,
              Integrator integrator)
      : settings_(settings),
        budget_(std::move(budget)),
        scene_(std::move(scene)),
        engine_(std::move(engine)),
        integrator_(integrator) {
    budget_->planned += weight();
    ++budget_->runs;
  }

  void measure(benchmark::State& state, const std::string& quantity, bool last) {
    for (auto _ : state) state.SetIterationTime(1.0);
    try {
      if (failure_.empty() && !history_) run();
      if (!failure_.empty()) throw EngineFailed(failure_);
      show(state, quantity);
    } catch (const std::exception& failure) {
      failure_ = failure.what();
      state.SkipWithError(failure_.c_str());
    }
    if (last) finish();
  }

 private:
  double weight() const { return weight_of(scene_, steps_of(scene_, settings_.quick)); }

  fs::path folder() const {
    std::string name = scene_ + "-" + engine_ + "-" + std::string(name_of(integrator_));
    std::ranges::replace(name, ':', '-');
    return settings_.cache / "long" / (settings_.quick ? "quick" : "full") / name;
  }

  void run() {
    try {
      const auto made = app::make_engine(engine_, {settings_.data, "", settings_.device});
      auto& engine = dynamic_cast<RestartableEngine&>(*made);
      unit_roundoff_ = engine.provenance().unit_roundoff;
      plan_ = long_plan(scene_, integrator_, settings_.quick);
      if (const Support support = engine.supports(plan_->scene, {}); !support)
        throw InputRefused("unsupported: " + support.because);
      const std::string who = scene_ + ", " + engine_ + ", " + std::string(name_of(integrator_));
      const auto tick = [&](std::int64_t step) {
        const double share = static_cast<double>(step) / static_cast<double>(plan_->steps);
        budget_->tell(who, budget_->done + share * weight());
        return true;
      };
      history_ = long_run(engine, *plan_, {folder(), program_stamp(settings_.data / "kernels")}, tick);
    } catch (const std::exception& failure) {
      failure_ = failure.what();
    }
    budget_->done += weight();
  }

  void show(benchmark::State& state, const std::string& quantity) {
    const LongVerdict verdict = long_verdict(*plan_, *history_, quantity, unit_roundoff_);
    state.counters["steps"] =
        static_cast<double>(history_->failed.empty() ? plan_->steps : history_->failed_at);
    state.counters["measured"] = verdict.measured;
    state.counters["bound"] = verdict.bound;
    state.counters["held"] = verdict.held ? 1.0 : 0.0;
    state.counters["wall_s"] = history_->wall_s;
    const std::size_t count = verdict.curve.size();
    // Closer together at the start, where a drift shows how it grows.
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (i < next && i + 1 < count) continue;
      state.counters["at_" + std::to_string(verdict.curve[i].first)] = verdict.curve[i].second;
      next = i + 1 + i * 3 / points_of_a_curve;
    }
    state.SetLabel(verdict.because);
  }

  /// What was kept is for a program that was killed; one that has shown everything starts anew next time.
  void finish() {
    if (++budget_->finished == budget_->runs)
      fs::remove_all(settings_.cache / "long" / (settings_.quick ? "quick" : "full"));
  }

  const Settings& settings_;
  std::shared_ptr<Budget> budget_;
  std::string scene_, engine_;
  Integrator integrator_;
  double unit_roundoff_ = 0.0;
  std::optional<LongPlan> plan_;
  std::optional<LongHistory> history_;
  std::string failure_;
};

void add_subject(const Settings& settings, const std::shared_ptr<Budget>& budget, const std::string& scene,
                 const std::string& engine, Integrator integrator) {
  const auto subject = std::make_shared<LongSubject>(settings, budget, scene, engine, integrator);
  const std::vector<std::string> quantities = long_quantities(scene, integrator);
  for (const std::string& quantity : quantities)
    add_manual("long/scene:" + scene + "/" + engine_key(engine) +
                   "/integrator:" + std::string(name_of(integrator)) + "/quantity:" + quantity + "/round:0",
               [subject, quantity, last = quantity == quantities.back()](benchmark::State& state) {
                 subject->measure(state, quantity, last);
               });
}

void add(const Settings& settings) {
  const auto budget = std::make_shared<Budget>();
  const std::vector<std::string> scenes =
      settings.scenes.empty() ? std::vector<std::string>{"bounces", "pile", "vibrated"} : settings.scenes;
  for (const std::string& scene : scenes)
    for (const std::string& engine : settings.engines)
      for (const Integrator integrator :
           {Integrator::velocity_verlet, Integrator::onset_corrected, Integrator::euler_trapezoid})
        add_subject(settings, budget, scene, engine, integrator);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
