// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>

#include "model/engine.hpp"
#include "reference_cpu/reference_engine.hpp"

/// Scenes built in C++, and runs of them, for the tests of the reference engine.
namespace grainproof::testing {

/// One material of density 2000 in a wide open box; everything else as the test says.
inline Scene empty_scene(const ContactLaws& laws, double step) {
  Scene scene;
  scene.run = {.end = 1e9, .step = step, .sample_times = {}};
  scene.domain = {.lower = Vec3::Constant(-10.0), .upper = Vec3::Constant(10.0)};
  scene.materials = {{"glass", 2000.0}};
  scene.contacts = ContactTable(1);
  scene.contacts.set(0, 0, laws);
  return scene;
}

inline ContactLaws linear(double stiffness, Dissipation dissipation, bool no_tension = false) {
  return {.normal = LinearNormal{stiffness, dissipation, no_tension}};
}

inline Particle& add_particle(Scene& scene, double diameter, const Vec3& position,
                              const Vec3& velocity = Vec3::Zero()) {
  scene.particles.push_back({.id = static_cast<std::int64_t>(scene.particles.size()) + 1,
                             .material = 0,
                             .diameter = diameter,
                             .effect_diameter = diameter,
                             .position = position,
                             .velocity = velocity});
  return scene.particles.back();
}

inline void add_plane(Scene& scene, const Vec3& point, const Vec3& normal) {
  scene.walls.push_back({"plane", 0, Plane{point, normal}});
}

/// Planes on all six faces of the domain.
inline void close_domain(Scene& scene) {
  for (int axis = 0; axis < 3; ++axis) {
    scene.domain.boundary[axis] = Boundary::wall;
    add_plane(scene, scene.domain.lower, Vec3::Unit(axis));
    add_plane(scene, scene.domain.upper, -Vec3::Unit(axis));
  }
}

inline std::unique_ptr<Run> start(const Scene& scene, bool ledger = false) {
  return reference::ReferenceEngine().start(scene, {.times = {}, .ledger = ledger});
}

/// The frame after `steps` steps from the start.
inline Frame frame_after(const Scene& scene, std::int64_t steps) {
  const auto run = start(scene);
  run->advance(steps);
  return run->frame();
}

/// Force on a particle in the state that the scene describes, from one explicit Euler step.
inline Vec3 force_on(Scene scene, std::size_t particle) {
  scene.run.integrator = Integrator::euler_trapezoid;
  const Frame frame = frame_after(scene, 1);
  const Particle& before = scene.particles[particle];
  const double density = scene.materials[before.material].density;
  const double mass = density * std::numbers::pi / 6.0 * std::pow(before.diameter, 3);
  return mass * (frame.velocity[particle] - before.velocity) / scene.run.step;
}

inline double sphere_mass(double diameter, double density = 2000.0) {
  return density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
}

/// The same numbers on every machine, which std::uniform_real_distribution does not promise.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  Vec3 in_box(const Vec3& low, const Vec3& high) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = between(low[axis], high[axis]);
    return point;
  }

 private:
  std::mt19937_64 bits_;
};

inline Vec3 momentum(const Scene& scene, const Frame& frame) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    if (!scene.particles[i].fixed) sum += sphere_mass(scene.particles[i].diameter) * frame.velocity[i];
  return sum;
}

}  // namespace grainproof::testing
