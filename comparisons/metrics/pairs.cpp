// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/pairs.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "comparisons/metrics/walls.hpp"

namespace grainproof {
namespace {

double radius(const Particle& particle, Surface surface) {
  return 0.5 * (surface == Surface::body ? particle.diameter : particle.effect_diameter);
}

double reach(const Scene& scene, const Pair& pair, Surface surface) {
  const double own = radius(scene.particles[pair.second], surface);
  return pair.first ? own + radius(scene.particles[*pair.first], surface) : own;
}

Vec3 velocity_of(const Scene& scene, const Frame& frame, std::size_t particle) {
  return scene.particles[particle].fixed ? Vec3(Vec3::Zero()) : frame.velocity[particle];
}

std::vector<Pair> pairs_of(const Scene& scene) {
  std::vector<Pair> pairs;
  const std::size_t count = scene.particles.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (scene.particles[i].fixed) continue;
    for (std::size_t w = 0; w < scene.walls.size(); ++w) pairs.push_back({i, std::nullopt, w});
    for (std::size_t j = 0; j < count; ++j)
      if (j < i || (j > i && scene.particles[j].fixed)) pairs.push_back({i, j, 0});
  }
  return pairs;
}

/// First root of |r + w t| = reach for t ≥ 0.
std::optional<double> sphere_touch(const Vec3& r, const Vec3& w, double reach) {
  const double approach = r.dot(w);
  const double excess = r.squaredNorm() - reach * reach;
  const double discriminant = approach * approach - w.squaredNorm() * excess;
  if (approach >= 0.0 || discriminant < 0.0) return std::nullopt;
  return excess / (-approach + std::sqrt(discriminant));
}

}  // namespace

Vec3 separation(const Domain& domain, const Vec3& from, const Vec3& to) {
  Vec3 r = to - from;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = domain.extent()[axis];
    if (domain.periodic(axis)) r[axis] -= length * std::round(r[axis] / length);
  }
  return r;
}

Vec3 normal(const Scene& scene, const Frame& frame, const Pair& pair) {
  const Vec3& x = frame.position[pair.second];
  if (pair.first) return separation(scene.domain, frame.position[*pair.first], x).normalized();
  return facing(scene.walls[pair.wall], x, frame.time).normal;
}

double gap(const Scene& scene, const Frame& frame, const Pair& pair, Surface surface) {
  const Vec3& x = frame.position[pair.second];
  const double distance = pair.first ? separation(scene.domain, frame.position[*pair.first], x).norm()
                                     : facing(scene.walls[pair.wall], x, frame.time).distance;
  return distance - reach(scene, pair, surface);
}

Vec3 relative_velocity(const Scene& scene, const Frame& frame, const Pair& pair) {
  const Vec3 v = velocity_of(scene, frame, pair.second);
  return v - (pair.first
                  ? velocity_of(scene, frame, *pair.first)
                  : facing(scene.walls[pair.wall], frame.position[pair.second], frame.time).surface_velocity);
}

Vec3 contact_velocity(const Scene& scene, const Frame& frame, const Pair& pair, const Vec3& normal) {
  Vec3 velocity = relative_velocity(scene, frame, pair);
  if (frame.angular_velocity.empty()) return velocity;
  const auto turning = [&](std::size_t particle) -> Vec3 {
    return radius(scene.particles[particle], Surface::body) * frame.angular_velocity[particle].cross(normal);
  };
  velocity -= turning(pair.second);
  if (pair.first && !scene.particles[*pair.first].fixed) velocity -= turning(*pair.first);
  return velocity;
}

std::optional<double> time_to_touch(const Scene& scene, const Frame& frame, const Pair& pair, Surface surface,
                                    double direction) {
  const Vec3 w = direction * relative_velocity(scene, frame, pair);
  std::optional<double> time;
  if (pair.first) {
    const Vec3 r = separation(scene.domain, frame.position[*pair.first], frame.position[pair.second]);
    time = sphere_touch(r, w, reach(scene, pair, surface));
  } else {
    const double wait = time_to_reach(scene.walls[pair.wall], frame.position[pair.second], frame.time, w,
                                      reach(scene, pair, surface));
    if (std::isfinite(wait)) time = wait;
  }
  if (time) *time *= direction;
  return time;
}

std::optional<Pair> first_contact(const Scene& scene, const Frame& frame, Surface surface) {
  std::optional<Pair> first;
  std::pair<double, double> earliest{std::numeric_limits<double>::infinity(), 0.0};
  for (const Pair& pair : pairs_of(scene)) {
    const double distance = gap(scene, frame, pair, surface);
    const auto time = distance < 0.0 ? std::optional(0.0) : time_to_touch(scene, frame, pair, surface);
    if (!time || std::pair(*time, distance) >= earliest) continue;
    earliest = {*time, distance};
    first = pair;
  }
  return first;
}

std::optional<Pair> deepest_contact(const Scene& scene, const Frame& frame) {
  std::optional<Pair> deepest;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Pair& pair : pairs_of(scene)) {
    const double distance = gap(scene, frame, pair);
    if (distance >= smallest) continue;
    smallest = distance;
    deepest = pair;
  }
  return deepest;
}

}  // namespace grainproof
