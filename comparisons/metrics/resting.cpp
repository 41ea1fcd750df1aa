// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/resting.hpp"

#include <cmath>
#include <cstddef>
#include <optional>

#include "comparisons/metrics/pairs.hpp"

namespace grainproof {
namespace {

/// The moving particle that a one-particle quantity is about, and the direction of its velocity.
struct Slider {
  std::size_t particle;
  Vec3 direction;
};

std::optional<Slider> slider(const Scene& scene, const Frame& first) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    if (!scene.particles[i].fixed && first.velocity[i].norm() > 0.0)
      return Slider{i, first.velocity[i].normalized()};
  return std::nullopt;
}

constexpr const char* at_rest = "nothing moves in the first frame";

}  // namespace

Measured resting_overlap(const Scene& scene, const Observations& seen) {
  const auto pair = deepest_contact(scene, seen.frames.back());
  if (!pair) return Measured::none("the scene has no two bodies that could touch");
  return Measured::of(-gap(scene, seen.frames.back(), *pair));
}

Measured stop_time(const Scene& scene, const Observations& seen) {
  const auto body = slider(scene, seen.frames.front());
  if (!body) return Measured::none(at_rest);
  const auto speed = [&](const Frame& frame) { return frame.velocity[body->particle].dot(body->direction); };
  for (std::size_t k = 1; k + 1 < seen.frames.size(); ++k) {
    const double length = seen.frames[k].time - seen.frames[k - 1].time;
    const double now = speed(seen.frames[k]);
    const double fall = speed(seen.frames[k - 1]) - now;
    const double next_fall = now - speed(seen.frames[k + 1]);
    const bool breaks_off = fall > 0.0 && next_fall < 0.5 * fall;
    if (breaks_off && std::abs(now) <= fall) return Measured::of(seen.frames[k].time + length * now / fall);
  }
  return Measured::none("the particle never stops");
}

Measured stop_distance(const Scene& scene, const Observations& seen) {
  const auto body = slider(scene, seen.frames.front());
  if (!body) return Measured::none(at_rest);
  Vec3 way = Vec3::Zero();  // summed frame by frame, since a periodic axis folds it
  for (std::size_t k = 1; k < seen.frames.size(); ++k)
    way += separation(scene.domain, seen.frames[k - 1].position[body->particle],
                      seen.frames[k].position[body->particle]);
  return Measured::of(way.dot(body->direction));
}

}  // namespace grainproof
