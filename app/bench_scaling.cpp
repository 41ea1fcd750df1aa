// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <fstream>

#include "app/bench_fit.hpp"
#include "app/bench_suites.hpp"
#include "model/errors.hpp"
#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

/// Andrews' list, with 6.5 and 8.5 million between: beyond the caches there are few others.
const std::vector<std::int64_t> all_sizes{10000,   100000,  200000,  300000,  400000,  500000,  700000,
                                          1000000, 2500000, 5000000, 6500000, 7500000, 8500000, 10000000};
const std::vector<std::int64_t> quick_sizes{10000, 20000, 40000, 80000};

constexpr double bytes_of_a_scene = 260.0;  ///< a particle, while a scene is made and copied into an engine
constexpr double longest_measurement_s = 120.0;
constexpr double fewest_steps = 40.0;  ///< warm-up, trial and the rounds
constexpr double caches_beyond = 4.0;

double available_bytes() {
  std::ifstream information("/proc/meminfo");
  std::string name;
  double kib = 0.0;
  for (std::string line; std::getline(information, line);)
    if (sscanf(line.c_str(), "MemAvailable: %lf", &kib) == 1) return 1024.0 * kib;
  return 0.0;
}

double last_level_cache_bytes() {
  return static_cast<double>(std::max(sysconf(_SC_LEVEL3_CACHE_SIZE), sysconf(_SC_LEVEL2_CACHE_SIZE)));
}

/// Why a size is not measured, judged by the one before; empty when it is.
std::string too_much(const Sample& before, double particles) {
  const double bytes = particles * (before.value("bytes_per_particle") + bytes_of_a_scene);
  if (bytes > 0.9 * available_bytes())
    return "left out: needs about " + report::brief(bytes / 1073741824.0) + " GiB of memory";
  const double seconds = fewest_steps * before.value("step_s") * particles / before.value("particles");
  if (seconds > longest_measurement_s) return "left out: takes about " + report::duration(seconds);
  return {};
}

Sample named(const std::string& scene, const std::string& engine, std::int64_t size) {
  const std::size_t colon = engine.find(':');
  Sample sample;
  sample.keys = {{"suite", "scaling"},
                 {"scene", scene},
                 {"engine", engine.substr(0, colon)},
                 {"precision", colon == std::string::npos ? "double" : engine.substr(colon + 1)},
                 {"size", std::to_string(size)}};
  return sample;
}

std::vector<Timed> timed(const std::vector<Sample>& samples, double least_bytes) {
  std::map<double, std::vector<double>> by_size;
  for (const Sample& one : samples)
    if (one.error.empty() && one.value("particles") * one.value("bytes_per_particle") >= least_bytes)
      by_size[one.value("particles")].push_back(one.value("step_s"));
  std::vector<Timed> points;
  for (const auto& [particles, seconds] : by_size) points.push_back({particles, spread_of(seconds).median});
  return points;
}

/// The intercept found, in s.
std::optional<double> add_fit(BenchSession& session, const std::vector<Sample>& samples, const char* over,
                              double least_bytes, std::optional<double> known_intercept = std::nullopt) {
  const std::vector<Timed> points = timed(samples, least_bytes);
  nlohmann::json fit{{"suite", "scaling"},
                     {"scene", samples.front().key("scene")},
                     {"engine", samples.front().key("engine")},
                     {"precision", samples.front().key("precision")},
                     {"over", over},
                     {"points", points.size()},
                     {"working_set_from_bytes", least_bytes}};
  const auto law = fit_power_law(points, known_intercept);
  if (law) {
    fit["exponent"] = law->exponent;
    fit["exponent_low"] = law->exponent_low;
    fit["exponent_high"] = law->exponent_high;
    fit["intercept_s"] = law->intercept;
    fit["factor_s"] = law->factor;
  }
  session.extra["fits"].push_back(std::move(fit));
  return law ? std::optional(law->intercept) : std::nullopt;
}

void measure_curve(BenchSession& session, const std::string& scene, const std::string& engine) {
  std::vector<Sample> curve;
  for (std::int64_t size : within_limits(session, session.quick() ? quick_sizes : all_sizes)) {
    const Sample before = curve.empty() ? Sample{} : curve.back();
    if (!curve.empty() && before.error.empty())
      if (const std::string because = too_much(before, static_cast<double>(size)); !because.empty()) {
        session.leave_out(named(scene, engine, size), because);
        continue;
      }
    const std::vector<Sample> found =
        session.run({.suite = "scaling",
                     .what = scene + ", " + engine + ", " + report::grouped(size),
                     .scenes = {scene},
                     .engines = {engine},
                     .particles = {size},
                     .rounds = session.quick() ? 2 : 3,
                     .seconds = session.quick() ? 0.2 : 2.0});
    curve.insert(curve.end(), found.begin(), found.end());
  }
  const auto intercept = add_fit(session, curve, "all sizes", 0.0);
  add_fit(session, curve, "sizes beyond the caches", caches_beyond * last_level_cache_bytes(), intercept);
}

}  // namespace

void measure_scaling(BenchSession& session) {
  for (const char* scene : {"bed", "gas"})
    for (const std::string& engine : session.engines()) measure_curve(session, scene, engine);
}

}  // namespace grainproof::app
