// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>
#include <tuple>

#include "analytic/contact_scales.hpp"
#include "app/engines.hpp"
#include "benchmarks/common/settling.hpp"
#include "benchmarks/common/stability_cases.hpp"
#include "benchmarks/common/stable_step.hpp"
#include "benchmarks/common/subject.hpp"
#include "model/errors.hpp"
#include "report/numbers.hpp"

namespace grainproof::bench {
namespace {

constexpr double growth_steps_per_contact = 20.0;
constexpr double linear_bar = 0.02, friction_bar = 0.05;  // predicted against measured

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

using Cases = std::vector<StabilityCase>;

void add_cases(Cases& cases, const std::string& arrangement, const std::vector<std::string>& restitutions,
               const std::vector<std::pair<double, double>>& ratios,
               const std::vector<std::string>& frictions) {
  for (const std::string& friction : frictions)
    for (const auto& [masses, stiffnesses] : ratios)
      for (const std::string& restitution : restitutions)
        cases.push_back({arrangement, restitution, masses, stiffnesses, friction});
}

const std::vector<std::string> both{"none", "history"};

Cases quick_cases() {
  Cases cases;
  add_cases(cases, "pair", {"none", "0.8", "overdamped"}, {{1, 1}, {1e6, 1}}, both);
  add_cases(cases, "pair", {"0.8"}, {{1, 1}}, {"step", "damped"});
  add_cases(cases, "wall", {"0.8"}, {{1, 1}}, {"none"});
  add_cases(cases, "chain", {"0.1"}, {{1e3, 100}}, {"none"});
  add_cases(cases, "face_centred", {"0.1"}, {{1, 1}}, both);
  add_cases(cases, "random_8", {"0.1"}, {{1, 1}}, {"none"});
  return cases;
}

/// Friction without memory is a drag at rest, as long as it is far below the Coulomb limit.
void add_forgetful(Cases& cases) {
  const std::vector<std::string> variants{"step", "collision_time", "damped"};
  add_cases(cases, "pair", {"none", "0.8", "0.1"}, {{1, 1}, {1e3, 1}}, variants);
  add_cases(cases, "wall", {"0.8", "0.1"}, {{1, 1}}, variants);
  add_cases(cases, "chain", {"0.8"}, {{1, 1}, {1e3, 100}}, variants);
  for (const char* arrangement : {"face_centred", "random_10"})
    add_cases(cases, arrangement, {"0.8"}, {{1, 1}}, variants);
}

Cases all_cases() {
  const std::vector<std::string> all{"none", "1", "0.95", "0.8", "0.5", "0.1", "0", "overdamped"};
  const std::vector<std::string> some{"none", "0.8", "0.1", "overdamped"};
  const std::vector<std::pair<double, double>> mixtures{{1, 1}, {1e3, 1}, {1, 100}, {1e6, 100}};
  Cases cases;
  add_cases(cases, "pair", all, {{1, 1}, {10, 1}, {100, 1}, {1e3, 1}, {1e4, 1}, {1e5, 1}, {1e6, 1}},
            {"none"});
  add_cases(cases, "pair", all, {{1, 1}, {1e3, 1}, {1e6, 1}}, {"history"});
  add_cases(cases, "wall", all, {{1, 1}}, both);
  add_cases(cases, "wall", some, {{1, 10}, {1, 1e3}}, both);
  for (const char* arrangement : {"chain", "simple_cubic", "face_centred"})
    add_cases(cases, arrangement, some, mixtures, both);
  for (const char* arrangement : {"random_8", "random_10", "random_12"})
    add_cases(cases, arrangement, some, {{1, 1}, {1e3, 1}, {1, 10}}, {"none"});
  add_cases(cases, "random_10", {"none", "0.8"}, {{1, 1}}, {"history"});
  add_forgetful(cases);
  return cases;
}

/// What another engine than the reference is asked for: the laws and arrangements, not every number.
bool is_representative(const StabilityCase& one, bool quick) {
  if (quick) return one.arrangement == "pair" && one.mass_ratio == 1.0 && one.restitution != "overdamped";
  if (one.arrangement == "simple_cubic")  // as many bodies as the path of small scenes takes
    return one.restitution == "0.8" && one.mass_ratio == 1.0 && one.stiffness_ratio == 1.0;
  return (one.restitution == "none" || one.restitution == "0.8" || one.restitution == "0.1") &&
         (one.mass_ratio == 1.0 || one.mass_ratio == 1e6) &&
         (one.stiffness_ratio == 1.0 || one.mass_ratio == 1e6);
}

const Scene& resting(const StabilityCase& of) {
  static std::map<std::string, Scene> known;
  const std::string key = of.arrangement + of.restitution + "/" + number(of.mass_ratio) + "/" +
                          number(of.stiffness_ratio) + "/" + of.friction;
  if (!known.contains(key)) known[key] = resting_scene(of);
  return known[key];
}

/// Once for all engines and for integrators that step alike.
const Prediction& prediction_of(const StabilityCase& of, Integrator integrator) {
  static std::map<std::tuple<const Scene*, decltype(analytic::LinearScheme::step), analytic::Weakening>,
                  Prediction>
      known;
  const Scene& scene = resting(of);
  const analytic::LinearScheme& scheme = analytic::linear_scheme(integrator);
  const auto key = std::tuple(&scene, scheme.step, scheme.weakens);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  return known.emplace(key, Prediction(scene, name_of(integrator))).first->second;
}

/// A guard that would permit more than the limit is no guard.
double permitted(Scene scene, Integrator integrator) {
  scene.run.integrator = integrator;
  return analytic::stability_limit(scene).step;
}

void measure_limit(benchmark::State& state, SteppingEngine& engine, const Scene& scene,
                   const Prediction& prediction, std::int64_t most_steps) {
  const MeasuredLimit limit = measured_limit(engine, scene, prediction, most_steps);
  state.counters["limit_s"] = limit.step;
  state.counters["error"] = std::abs(limit.step / prediction.limit() - 1.0);
  state.counters["contact_times"] = limit.contact_times;
  state.counters["runs"] = limit.runs;
  state.counters["share_of_contact"] = limit.step / contact_time_of(scene);
}

/// No step is stable: the rate of growth is what can be held against the prediction.
void measure_growth(benchmark::State& state, SteppingEngine& engine, const Scene& scene,
                    const Prediction& prediction) {
  const double step = contact_time_of(scene) / growth_steps_per_contact;
  const double predicted = std::log(prediction.growth(step));
  const double measured = measured_growth(engine, scene, step, predicted);
  state.counters["limit_s"] = 0.0;
  state.counters["share_of_contact"] = 0.0;
  state.counters["growth_a_step"] = measured;
  state.counters["predicted_growth"] = predicted;
  state.counters["error"] = std::abs(measured / predicted - 1.0);
}

void measure_case(benchmark::State& state, const Settings& settings, const std::string& name,
                  Integrator integrator, const StabilityCase& of) {
  const bool random = of.arrangement.starts_with("random");
  if (random && (name == "opencl:single" || name == "opencl:mixed"))
    throw InputRefused(
        "unsupported: a move that keeps every contact of a packing is lost in single rounding");
  Scene scene = resting(of);
  scene.run.integrator = integrator;
  const auto made = app::make_engine(name, {settings.data, "", settings.device});
  auto& engine = dynamic_cast<SteppingEngine&>(*made);
  scene.run.step = 1e-3 * contact_time_of(scene);
  if (const Support support = engine.supports(scene, {}); !support)
    throw InputRefused("unsupported: " + support.because);
  const Prediction& prediction = prediction_of(of, integrator);
  const std::int64_t most_steps = settings.quick ? 50000 : 1000000;
  for (auto _ : state) {
    if (prediction.limit() > 0.0)
      measure_limit(state, engine, scene, prediction, most_steps);
    else
      measure_growth(state, engine, scene, prediction);
    state.SetIterationTime(1.0);
  }
  state.counters["predicted_s"] = prediction.limit();
  state.counters["permitted_s"] = permitted(scene, integrator);
  state.counters["contact_s"] = contact_time_of(scene);
  state.counters["coordination"] = most_contacts(scene);
  state.counters["bar"] = of.friction != "none" || random ? friction_bar : linear_bar;
}

/// How much of the map is drawn, once a minute: a map takes hours.
class Told {
 public:
  void expect_one() { ++expected_; }

  void tell() {
    const auto now = Clock::now();
    if (done_++ == 0) began_ = told_ = now;
    if (now - told_ < std::chrono::minutes(1)) return;
    told_ = now;
    const double spent = std::chrono::duration<double>(now - began_).count();
    std::cout << "note: stability: " << done_ << " of " << expected_ << ", "
              << report::duration(spent * (expected_ - done_) / (done_ - 1)) << " to go" << std::endl;
  }

 private:
  using Clock = std::chrono::steady_clock;
  int expected_ = 0, done_ = 0;
  Clock::time_point began_, told_;
};

void add_row(const std::string& name, const std::function<void(benchmark::State&)>& measure) {
  static Told told;
  told.expect_one();
  add_manual(name, [measure](benchmark::State& state) {
    try {
      measure(state);
    } catch (const std::exception& failure) {
      state.SkipWithError(failure.what());
    }
    told.tell();
  });
}

void add_case(const Settings& settings, const std::string& engine, Integrator integrator,
              const StabilityCase& of) {
  add_row("stability/scene:" + of.arrangement + "/" + engine_key(engine) +
              "/integrator:" + std::string(name_of(integrator)) + "/restitution:" + of.restitution +
              "/mass_ratio:" + number(of.mass_ratio) + "/stiffness_ratio:" + number(of.stiffness_ratio) +
              "/friction:" + of.friction + "/round:0",
          [&settings, engine, integrator, of](benchmark::State& state) {
            measure_case(state, settings, engine, integrator, of);
          });
}

void add_settling(const Settings& settings, const std::string& engine, Integrator integrator, double step,
                  double end) {
  add_row(
      "stability/scene:settling/" + engine_key(engine) + "/integrator:" + std::string(name_of(integrator)) +
          "/step:" + number(step) + "/end:" + number(end) + "/round:0",
      [&settings, engine, integrator, step, end](benchmark::State& state) {
        const auto made = app::make_engine(engine, {settings.data, "", settings.device});
        const Settled settled = settle_overlap(dynamic_cast<SteppingEngine&>(*made), integrator, step, end);
        for (auto _ : state) state.SetIterationTime(1.0);
        if (settled.went_wrong) return state.SkipWithError("went wrong: the sphere was lost");
        state.counters["overlap_error"] = settled.error;
      });
}

bool is_asked_for(const Settings& settings, const std::string& scene) {
  return settings.scenes.empty() || std::ranges::find(settings.scenes, scene) != settings.scenes.end();
}

void add(const Settings& settings) {
  for (const StabilityCase& of : settings.quick ? quick_cases() : all_cases())
    for (const std::string& engine : settings.engines)
      for (const auto& [name, integrator] : integrator_names) {
        if (integrator == Integrator::euler_trapezoid_implicit_drag && of.arrangement != "pair")
          continue;  // without drag the same as explicit
        if (is_asked_for(settings, of.arrangement) &&
            (engine == "reference" || is_representative(of, settings.quick)))
          add_case(settings, engine, integrator, of);
      }
  if (!is_asked_for(settings, "settling")) return;
  for (const std::string& engine : settings.engines)
    for (const double end : settings.quick ? std::vector<double>{1.0} : std::vector<double>{1.0, 20.0})
      for (const Integrator integrator : {Integrator::euler_trapezoid, Integrator::velocity_verlet})
        for (const double step : settling_steps(settings.quick))
          add_settling(settings, engine, integrator, step, end);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
