// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/collision.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "comparisons/metrics/pairs.hpp"

namespace grainproof {
namespace {

constexpr const char* no_contact = "no two bodies of this scene meet";

/// A collision as its first and last frame show it; velocities at the contact.
struct Encounter {
  Vec3 normal;
  Vec3 before;
  Vec3 after;
};

Frame flown(const Frame& frame, double time) {
  Frame later = frame;
  for (std::size_t i = 0; i < frame.position.size(); ++i) later.position[i] += time * frame.velocity[i];
  return later;
}

std::optional<Encounter> encounter(const Scene& scene, const Observations& seen) {
  const Frame& first = seen.frames.front();
  const Frame& last = seen.frames.back();
  const auto pair = first_contact(scene, first);
  if (!pair) return std::nullopt;
  const double wait = gap(scene, first, *pair) > 0.0 ? *time_to_touch(scene, first, *pair) : 0.0;
  const Vec3 n = normal(scene, flown(first, wait), *pair);
  return Encounter{n, contact_velocity(scene, first, *pair, n), contact_velocity(scene, last, *pair, n)};
}

bool still_touching(const Scene& scene, const Observations& seen) {
  const auto pair = first_contact(scene, seen.frames.front());
  return pair && gap(scene, seen.frames.back(), *pair) < 0.0;
}

/// Frames before the first touch and after the first parting; the contact is strictly between.
struct Span {
  std::size_t before;
  std::size_t after;
};

std::optional<Span> first_span(const Scene& scene, const Observations& seen, const Pair& pair) {
  const auto touches = [&](const Frame& frame) { return gap(scene, frame, pair) < 0.0; };
  const auto begin = std::find_if(seen.frames.begin(), seen.frames.end(), touches);
  const auto end = std::find_if_not(begin, seen.frames.end(), touches);
  if (begin == seen.frames.end()) return std::nullopt;
  const auto index = [&](auto frame) { return static_cast<std::size_t>(frame - seen.frames.begin()); };
  return Span{begin == seen.frames.begin() ? 0 : index(begin) - 1, index(end)};
}

/// Largest value of the cubic with values a, b and slopes da, db at the ends of a step of length h.
double hermite_peak(double a, double da, double b, double db, double h) {
  const double rise = b - a;
  const double c3 = (da + db) * h - 2.0 * rise;
  const double c2 = 3.0 * rise - (2.0 * da + db) * h;
  const double c1 = da * h;
  double peak = std::max(a, b);
  const double root = std::sqrt(std::max(c2 * c2 - 3.0 * c3 * c1, 0.0));
  for (const double s : {c1 / (-c2 + root), c1 / (-c2 - root)})
    if (s > 0.0 && s < 1.0) peak = std::max(peak, a + s * (c1 + s * (c2 + s * c3)));
  return peak;
}

double deepening(const Scene& scene, const Frame& frame, const Pair& pair) {
  return -relative_velocity(scene, frame, pair).dot(normal(scene, frame, pair));
}

}  // namespace

Measured restitution(const Scene& scene, const Observations& seen) {
  const auto met = encounter(scene, seen);
  if (!met) return Measured::none(no_contact);
  if (still_touching(scene, seen)) return Measured::none("the bodies still touch at the end of the run");
  return Measured::of(-met->after.dot(met->normal) / met->before.dot(met->normal));
}

Measured tangential_velocity_change(const Scene& scene, const Observations& seen) {
  const auto met = encounter(scene, seen);
  if (!met) return Measured::none(no_contact);
  const Vec3 slip = met->before - met->before.dot(met->normal) * met->normal;
  if (slip.norm() == 0.0) return Measured::none("the bodies do not slip");
  return Measured::of((met->before - met->after).dot(slip.normalized()));
}

Measured contact_duration(const Scene& scene, const Observations& seen) {
  const auto pair = first_contact(scene, seen.frames.front());
  const auto span = pair ? first_span(scene, seen, *pair) : std::nullopt;
  if (!span) return Measured::none(no_contact);
  if (span->after == seen.frames.size())
    return Measured::none("the bodies still touch at the end of the run");
  const Frame& in = seen.frames[span->before];
  const Frame& out = seen.frames[span->after];
  const double start = gap(scene, in, *pair) < 0.0 ? 0.0 : time_to_touch(scene, in, *pair).value_or(0.0);
  const double end = time_to_touch(scene, out, *pair, Surface::body, -1.0).value_or(0.0);
  return Measured::of((out.time + end) - (in.time + start));
}

Measured peak_overlap(const Scene& scene, const Observations& seen) {
  const auto pair = first_contact(scene, seen.frames.front());
  const auto span = pair ? first_span(scene, seen, *pair) : std::nullopt;
  if (!span) return Measured::none(no_contact);
  double peak = 0.0;
  for (std::size_t k = span->before; k + 1 < seen.frames.size() && k < span->after; ++k) {
    const Frame& a = seen.frames[k];
    const Frame& b = seen.frames[k + 1];
    peak = std::max(peak, hermite_peak(-gap(scene, a, *pair), deepening(scene, a, *pair),
                                       -gap(scene, b, *pair), deepening(scene, b, *pair), b.time - a.time));
  }
  return Measured::of(peak);
}

}  // namespace grainproof
