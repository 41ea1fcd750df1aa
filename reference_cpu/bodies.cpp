// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/bodies.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "reference_cpu/laws/drag.hpp"

namespace grainproof::reference {
namespace {

double sphere_mass(double density, double diameter) {
  return density * std::numbers::pi * diameter * diameter * diameter / 6.0;
}

double reach_of(const Particle& particle, bool cohesion) {
  return 0.5 * (cohesion ? particle.effect_diameter : particle.diameter);
}

void append(Bodies& bodies, const Particle& particle, double density, bool cohesion) {
  const double mass = sphere_mass(density, particle.diameter);
  const double inverse_mass = particle.fixed ? 0.0 : 1.0 / mass;
  bodies.body.push_back({particle.position, 0.5 * particle.diameter, particle.velocity, inverse_mass});
  bodies.acceleration.push_back(Vec3::Zero());
  bodies.mass.push_back(mass);
  bodies.reach.push_back(reach_of(particle, cohesion));
  bodies.material.push_back(particle.material);
  bodies.origin.push_back(static_cast<std::int32_t>(bodies.origin.size()));
}

// A sphere's inertia is 2/5 m r².
void append_spin(Bodies& bodies, const Particle& particle) {
  const Body& body = bodies.body.back();
  bodies.spin.push_back({particle.angular_velocity, body.inverse_mass / (0.4 * body.radius * body.radius)});
  bodies.angular_acceleration.push_back(Vec3::Zero());
}

void make_room_for_halves(Bodies& bodies) {
  bodies.half_velocity.assign(bodies.size(), Vec3::Zero());
  bodies.half_spin.assign(bodies.spin.size(), Vec3::Zero());
}

}  // namespace

void reorder(Bodies& bodies, const std::vector<std::int32_t>& order) {
  const auto reordered = [&](auto& values) {
    const auto before = values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = before[order[i]];
  };
  reordered(bodies.body);
  reordered(bodies.spin);
  reordered(bodies.half_velocity);
  reordered(bodies.half_spin);
  reordered(bodies.orientation);
  reordered(bodies.mass);
  reordered(bodies.reach);
  reordered(bodies.drag_rate);
  reordered(bodies.material);
  reordered(bodies.origin);
}

bool has_cohesion(const Scene& scene) {
  const std::size_t materials = scene.contacts.materials();
  for (std::size_t a = 0; a < materials; ++a)
    for (std::size_t b = a; b < materials; ++b)
      if (scene.contacts.has(a, b) && !std::holds_alternative<NoCohesion>(scene.contacts.at(a, b).cohesion))
        return true;
  return false;
}

double largest_reach(const Scene& scene) {
  double largest = 0.0;
  for (const Particle& particle : scene.particles)
    largest = std::max(largest, reach_of(particle, has_cohesion(scene)));
  return largest;
}

double smallest_reach(const Scene& scene) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Particle& particle : scene.particles)
    smallest = std::min(smallest, reach_of(particle, has_cohesion(scene)));
  return smallest;
}

Bodies bodies_of(const Scene& scene) {
  Bodies bodies;
  bodies.body.reserve(scene.particles.size());
  const bool cohesion = has_cohesion(scene);
  const bool flow = !std::holds_alternative<NoFlow>(scene.flow);
  for (const Particle& particle : scene.particles) {
    const double density = scene.materials[particle.material].density;
    append(bodies, particle, density, cohesion);
    if (scene.rotation) append_spin(bodies, particle);
    if (flow) bodies.drag_rate.push_back(drag_rate(density, particle.diameter, viscosity_of(scene.flow)));
  }
  if (scene.orientation != OrientationUpdate::none)
    bodies.orientation.assign(bodies.size(), Quaternion::Identity());
  if (holds_half_steps(scene.run.integrator)) make_room_for_halves(bodies);
  return bodies;
}

Motion motion_after(const Bodies& bodies, double pending) {
  if (bodies.predicted) return {bodies.half_velocity, bodies.half_spin};
  Motion motion{std::vector<Vec3>(bodies.size()), std::vector<Vec3>(bodies.spin.size())};
  for (std::size_t i = 0; i < bodies.size(); ++i)
    motion.velocity[i] = bodies.body[i].velocity + bodies.acceleration[i] * pending;
  for (std::size_t i = 0; i < bodies.spin.size(); ++i)
    motion.angular_velocity[i] = bodies.spin[i].angular_velocity + bodies.angular_acceleration[i] * pending;
  return motion;
}

}  // namespace grainproof::reference
