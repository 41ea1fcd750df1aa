// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.hpp"

#include <cmath>
#include <numbers>

namespace grainproof::opencl::testing {

using std::numbers::pi;

double sphere_mass(double of_density, double of_diameter) {
  return of_density * pi * std::pow(of_diameter, 3) / 6.0;
}

double contact_time(double mass, double k, double restitution) {
  const double l = std::log(restitution);
  const double eta = -2.0 * l * std::sqrt(mass * k / (pi * pi + l * l));
  return pi / std::sqrt(k / mass - std::pow(eta / (2.0 * mass), 2));
}

Scene empty_scene(double restitution) {
  Scene scene;
  scene.domain = {Vec3::Constant(-1.0), Vec3::Constant(1.0), {}};
  scene.materials = {{"glass", density}};
  scene.contacts = ContactTable(1);
  scene.contacts.set(
      0, 0, {LinearNormal{stiffness, Restitution{restitution}, false}, Frictionless{}, NoCohesion{}});
  scene.run.integrator = Integrator::velocity_verlet;
  scene.run.step = contact_time(sphere_mass(density, diameter), stiffness, restitution) / 64.0;
  return scene;
}

Particle sphere(std::int64_t id, const Vec3& position, const Vec3& velocity, double of_diameter) {
  Particle p{};
  p.id = id;
  p.diameter = p.effect_diameter = of_diameter;
  p.position = position;
  p.velocity = velocity;
  return p;
}

Scene head_on_scene(double restitution, double steps_per_contact) {
  Scene scene = empty_scene(restitution);
  const double contact = contact_time(sphere_mass(density, diameter), stiffness, restitution);
  scene.run.step = contact / steps_per_contact;
  scene.run.end = 3.0 * contact;
  scene.run.sample_times = {0.0, scene.run.end};
  scene.particles = {sphere(0, Vec3::Zero(), Vec3::Zero()), sphere(1, {0.1005, 0, 0}, {-2, 0, 0})};
  scene.particles[0].fixed = true;
  return scene;
}

Scene settling_scene(double contacts) {
  Scene scene = empty_scene(0.8);
  scene.walls = {{"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}}};
  scene.gravity = ConstantGravity{{0, 0, -9.81}};
  scene.particles = {sphere(0, {0, 0, 0.05}, Vec3::Zero())};
  scene.run.end = contacts * 64.0 * scene.run.step;
  scene.run.sample_times = {0.0, scene.run.end};
  return scene;
}

}  // namespace grainproof::opencl::testing
