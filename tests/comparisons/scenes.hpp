// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <numbers>

#include "model/scene.hpp"

/// Small scenes for the tests of this folder.
namespace grainproof::test {

/// One material "glass" that touches itself by one law.
inline Scene scene_of(ContactLaws laws, double half_width = 0.5) {
  Scene scene;
  scene.domain.lower = Vec3::Constant(-half_width);
  scene.domain.upper = Vec3::Constant(half_width);
  scene.materials = {{"glass", 2000.0}};
  scene.contacts = ContactTable(1);
  scene.contacts.set(0, 0, laws);
  return scene;
}

inline Particle particle(std::int64_t id, Vec3 position, Vec3 velocity, bool fixed = false,
                         double diameter = 0.1) {
  return {id, 0, fixed, diameter, diameter, position, velocity};
}

inline void run_for(Scene& scene, double end, double step) {
  scene.run.end = end;
  scene.run.step = step;
  scene.run.sample_times = {0.0, end};
}

inline double mass(double diameter = 0.1) {
  return 2000.0 * std::numbers::pi * std::pow(diameter, 3) / 6.0;
}

/// η = −2 ln ε sqrt(m k/(π² + ln² ε)).
inline double dashpot(double restitution, double m, double k) {
  const double l = std::log(restitution);
  return -2.0 * l * std::sqrt(m * k / (std::numbers::pi * std::numbers::pi + l * l));
}

constexpr double stiffness = 1e5;
constexpr double restitution_value = 0.8;

/// The catalogue's normal collision: a fixed sphere at the origin, one that comes at 2 m/s along x and
/// first touches after `phase` of a step of `1/steps` of a contact.
inline Scene collision_with_fixed(double steps, double phase, double restitution = restitution_value) {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{restitution}}});
  const double eta = restitution < 1.0 ? dashpot(restitution, mass(), stiffness) : 0.0;
  const double contact = std::numbers::pi / std::sqrt(stiffness / mass() - std::pow(eta / (2.0 * mass()), 2));
  run_for(scene, 1.5 * contact, contact / steps);
  scene.particles = {particle(1, Vec3::Zero(), Vec3::Zero(), true),
                     particle(2, Vec3(0.1 + 2.0 * phase * scene.run.step, 0.0, 0.0), Vec3(-2.0, 0.0, 0.0))};
  return scene;
}

}  // namespace grainproof::test
