// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/stability_meter.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "analytic/contact_scales.hpp"
#include "app/engines.hpp"
#include "benchmarks/common/settling.hpp"
#include "benchmarks/common/stability_map.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double growth_steps_per_contact = 20.0;
constexpr double linear_bar = 0.02, friction_bar = 0.05;  // predicted against measured
constexpr double most_steps = 1e6, most_steps_quick = 5e4;
constexpr double most_body_steps = 8e6;  // so that no row takes minutes

bool is_random(const StabilityCase& of) {
  return of.arrangement.starts_with("random");
}

/// A guard that would permit more than the limit is no guard.
double permitted(Scene scene, Integrator integrator) {
  scene.run.integrator = integrator;
  return analytic::stability_limit(scene).step;
}

MeasuredRow limit_row(SteppingEngine& engine, const Scene& scene, const Prediction& prediction,
                      double longest) {
  const MeasuredLimit limit = measured_limit(engine, scene, prediction, static_cast<std::int64_t>(longest));
  return {{{"limit_s", limit.step()},
           {"stable_s", limit.stable},
           {"unstable_s", limit.unstable},
           {"error", limit.farthest_from(prediction.limit())},
           {"contact_times", limit.contact_times},
           {"runs", static_cast<double>(limit.runs)},
           {"share_of_contact", limit.step() / contact_time_of(scene)}},
          ""};
}

/// No step is stable: the rate of growth is what can be held against the prediction.
MeasuredRow growth_row(SteppingEngine& engine, const Scene& scene, const Prediction& prediction) {
  const double step = contact_time_of(scene) / growth_steps_per_contact;
  const double predicted = std::log(prediction.growth(step));
  const double measured = measured_growth(engine, scene, step, predicted);
  return {{{"limit_s", 0.0},
           {"share_of_contact", 0.0},
           {"growth_a_step", measured},
           {"predicted_growth", predicted},
           {"error", std::abs(measured / predicted - 1.0)}},
          ""};
}

}  // namespace

const Scene& StabilityMeter::resting(const StabilityCase& of) {
  return scenes_.get(name_of(of, "", ""), [&] { return resting_scene(of); });
}

const Prediction& StabilityMeter::prediction_of(const Scene& resting, Integrator integrator) {
  const analytic::LinearScheme& scheme = analytic::linear_scheme(integrator);
  return predictions_.get({&resting, scheme.step, scheme.weakens},
                          [&] { return Prediction(resting, name_of(integrator)); });
}

std::unique_ptr<SteppingEngine> StabilityMeter::take_engine(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = engines_.find(name); found != engines_.end())
      return std::move(engines_.extract(found).mapped());
  }
  // One at a time: while one thread starts PoCL another finds devices that are not ready.
  const std::lock_guard alone(making_);
  auto made = app::make_engine(name, {settings_.data, "", settings_.device});
  auto* stepping = dynamic_cast<SteppingEngine*>(made.get());
  if (stepping == nullptr) throw InputRefused("found engine " + name + "; expected one that steps");
  made.release();
  return std::unique_ptr<SteppingEngine>(stepping);
}

void StabilityMeter::put_back(const std::string& name, std::unique_ptr<SteppingEngine> engine) {
  const std::lock_guard lock(mutex_);
  engines_.emplace(name, std::move(engine));
}

MeasuredRow StabilityMeter::measured(const std::string& engine,
                                     const std::function<MeasuredRow(SteppingEngine&)>& measure) {
  const auto began = Clock::now();
  try {
    auto taken = take_engine(engine);
    MeasuredRow row = measure(*taken);
    put_back(engine, std::move(taken));
    row.values["wall_s"] = std::chrono::duration<double>(Clock::now() - began).count();
    return row;
  } catch (const std::exception& failure) {
    return {{}, failure.what()};
  }
}

MeasuredRow StabilityMeter::limit(const std::string& name, Integrator integrator, const StabilityCase& of) {
  if (is_random(of) && (name == "opencl:single" || name == "opencl:mixed"))
    return {{}, "unsupported: a move that keeps every contact of a packing is lost in single rounding"};
  return measured(name, [&](SteppingEngine& engine) -> MeasuredRow {
    const Scene& at_rest = resting(of);
    Scene scene = at_rest;
    scene.run.integrator = integrator;
    scene.run.step = 1e-3 * contact_time_of(scene);
    if (const Support support = engine.supports(scene, {}); !support)
      return {{}, "unsupported: " + support.because};
    const Prediction& prediction = prediction_of(at_rest, integrator);
    const double longest = std::min(settings_.quick ? most_steps_quick : most_steps,
                                    most_body_steps / static_cast<double>(scene.particles.size()));
    MeasuredRow row = prediction.limit() > 0.0 ? limit_row(engine, scene, prediction, longest)
                                               : growth_row(engine, scene, prediction);
    row.values["predicted_s"] = prediction.limit();
    row.values["permitted_s"] = permitted(scene, integrator);
    row.values["contact_s"] = contact_time_of(scene);
    row.values["coordination"] = most_contacts(scene);
    row.values["bar"] = of.friction != "none" || is_random(of) ? friction_bar : linear_bar;
    return row;
  });
}

MeasuredRow StabilityMeter::settled(const std::string& name, Integrator integrator, double step, double end) {
  return measured(name, [&](SteppingEngine& engine) -> MeasuredRow {
    const Settled found = settle_overlap(engine, integrator, step, end);
    if (found.went_wrong) return {{}, "went wrong: the sphere was lost"};
    return {{{"overlap_error", found.error}}, ""};
  });
}

}  // namespace grainproof::bench
