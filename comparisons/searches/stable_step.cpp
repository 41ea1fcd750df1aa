// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "comparisons/metrics/mass.hpp"
#include "comparisons/searches/experiment.hpp"

namespace grainproof {
namespace {

constexpr double spread = 0.02;
constexpr double accuracy = 1e-4;  // a hundredth of the tightest bound on this quantity
constexpr double falling = 0.99;   // of the speed half a run before
constexpr double at_rest = 1e-3;   // of the speed at first: stable, whatever round-off does then
constexpr std::int64_t window_steps = 256;
constexpr double window_periods = 3.0;

/// The slowest undamped oscillation that any contact of the scene has, s; 0 without contacts. That of
/// a Hertz contact depends on its load, so it sets no window.
double slowest_period(const Scene& scene) {
  double slowest = 0.0;
  for (const Particle& particle : scene.particles)
    for (std::size_t other = 0; other < scene.contacts.materials(); ++other) {
      const auto own = static_cast<std::size_t>(particle.material);
      if (!scene.contacts.has(own, other)) continue;
      const auto* law = std::get_if<LinearNormal>(&scene.contacts.at(own, other).normal);
      if (!law) continue;
      slowest =
          std::max(slowest, 2.0 * std::numbers::pi * std::sqrt(mass_of(scene, particle) / law->stiffness));
    }
  return slowest;
}

/// Steps of one window, at most a quarter of the run.
std::int64_t window_of(const Scene& scene) {
  const auto last = step_at_or_after(scene.run.end, scene.run.step);
  const auto periods =
      static_cast<std::int64_t>(std::ceil(window_periods * slowest_period(scene) / scene.run.step));
  return std::max<std::int64_t>(1, std::min(std::max(window_steps, periods), last / 4));
}

/// Frames in three windows: at the start, up to the middle, up to the end.
Scene with_step(const Scene& scene, double step) {
  Scene tried = scene;
  tried.run.step = step;
  const std::int64_t last = step_at_or_after(scene.run.end, step);
  const std::int64_t window = window_of(tried);
  tried.run.sample_times.clear();
  for (const std::int64_t end : {window, last / 2, last})
    for (std::int64_t n = end - window + 1; n <= end; ++n)
      tried.run.sample_times.push_back(static_cast<double>(n) * step);
  tried.run.end = static_cast<double>(last) * step;
  return tried;
}

double largest_speed(const Observations& seen, std::int64_t from, std::int64_t to) {
  double largest = 0.0;
  for (const Frame& frame : seen.frames) {
    if (frame.step <= from || frame.step > to) continue;
    for (const Vec3& velocity : frame.velocity) {
      if (!velocity.allFinite()) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, velocity.norm());
    }
  }
  return largest;
}

Side unstable(const Scene& tried, const Observations& seen) {
  if (seen.outcome.status == Outcome::Status::went_wrong) return {true, {}};
  const std::int64_t last = step_at_or_after(tried.run.end, tried.run.step);
  const std::int64_t window = window_of(tried);
  const double first = largest_speed(seen, 0, window);
  const double middle = largest_speed(seen, last / 2 - window, last / 2);
  const double final = largest_speed(seen, last - window, last);
  if (first == 0.0 && middle == 0.0) return {false, "nothing moves, so nothing can grow"};
  const bool stable = final < at_rest * first || final < falling * middle;
  return {!stable, {}};
}

}  // namespace

std::vector<Found> stable_step(std::span<const Scene> scenes, Engine& engine, std::span<const double> hints) {
  std::vector<double> guesses;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    guesses.push_back(std::isfinite(hints[i]) ? hints[i] : scenes[i].run.step);
  return search(scenes, engine, guesses, spread, accuracy, {with_step, unstable});
}

}  // namespace grainproof
