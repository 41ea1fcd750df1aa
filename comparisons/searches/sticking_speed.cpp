// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "comparisons/metrics/pairs.hpp"
#include "comparisons/searches/experiment.hpp"

namespace grainproof {
namespace {

constexpr double spread = 0.02;
constexpr double accuracy = 1e-5;  // a hundredth of the tightest bound on this quantity

Frame start_of(const Scene& scene) {
  Frame frame;
  for (const Particle& particle : scene.particles) {
    frame.position.push_back(particle.position);
    frame.velocity.push_back(particle.velocity);
  }
  return frame;
}

/// All velocities by `factor`. The way to the effect surface shrinks alike, so it takes the same time.
Scene at_speed(const Scene& scene, double factor) {
  const Frame start = start_of(scene);
  const auto pair = first_contact(scene, start, Surface::effect);
  const auto wait = pair ? time_to_touch(scene, start, *pair, Surface::effect) : std::nullopt;
  const double flight = wait && *wait > 0.0 ? *wait : 0.0;
  Scene slower = scene;
  for (Particle& particle : slower.particles) {
    if (particle.fixed) continue;
    particle.position += (1.0 - factor) * flight * particle.velocity;
    particle.velocity *= factor;
  }
  return slower;
}

Side escaped(const Scene& tried, const Observations& seen) {
  if (seen.outcome.status == Outcome::Status::went_wrong || seen.frames.empty())
    return {false, "went wrong: " + seen.outcome.reason};
  const auto pair = first_contact(tried, start_of(tried), Surface::effect);
  const Frame& last = seen.frames.back();
  const double receding = relative_velocity(tried, last, *pair).dot(normal(tried, last, *pair));
  if (!std::isfinite(receding)) return {false, "the last frame has a number that is not finite"};
  return {gap(tried, last, *pair, Surface::effect) > 0.0 && receding > 0.0, {}};
}

/// Relative speed of the pair that meets; zero where none does.
double speed_of(const Scene& scene) {
  const Frame start = start_of(scene);
  const auto pair = first_contact(scene, start, Surface::effect);
  return pair ? relative_velocity(scene, start, *pair).norm() : 0.0;
}

}  // namespace

std::vector<Found> sticking_speed(std::span<const Scene> scenes, Engine& engine,
                                  std::span<const double> hints) {
  std::vector<double> guesses;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const double speed = speed_of(scenes[i]);
    if (speed == 0.0)
      return {scenes.size(),
              Found{Measured::none("no two bodies of this scene approach each other"), {}, 0.0}};
    guesses.push_back(std::isfinite(hints[i]) ? hints[i] / speed : 1.0);
  }
  std::vector<Found> found = search(scenes, engine, guesses, spread, accuracy, {at_speed, escaped});
  for (std::size_t i = 0; i < scenes.size(); ++i) found[i].value.value *= speed_of(scenes[i]);
  return found;
}

}  // namespace grainproof
