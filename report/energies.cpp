// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/energies.hpp"

#include <cmath>
#include <numbers>

namespace grainproof::report {
namespace {

double mass_of(const Scene& scene, const Particle& particle) {
  const double d = particle.diameter;
  return scene.materials[static_cast<std::size_t>(particle.material)].density * std::numbers::pi / 6.0 * d *
         d * d;
}

double in_spring(const Scene& scene, const ContactLaws& laws, std::pair<std::size_t, std::size_t> materials,
                 double radius, double overlap) {
  if (const auto* linear = std::get_if<LinearNormal>(&laws.normal))
    return 0.5 * linear->stiffness * overlap * overlap;
  const auto compliance = [&](std::size_t m) {
    const Elasticity& e = scene.materials[m].elasticity.value();
    return (1.0 - e.poisson_ratio * e.poisson_ratio) / e.youngs_modulus;
  };
  const double modulus = 1.0 / (compliance(materials.first) + compliance(materials.second));
  return 8.0 / 15.0 * modulus * std::sqrt(radius) * std::pow(overlap, 2.5);
}

std::optional<double> gravitational(const Scene& scene, const Frame& frame) {
  const auto* constant = std::get_if<ConstantGravity>(&scene.gravity);
  if (constant == nullptr) return {};
  const Vec3& g = constant->acceleration;
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.periodic(axis) && g[axis] != 0.0) return {};
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    if (!scene.particles[i].fixed) sum -= mass_of(scene, scene.particles[i]) * g.dot(frame.position[i]);
  return sum;
}

}  // namespace

double kinetic_energy(const Scene& scene, const Frame& frame, std::size_t i) {
  const Particle& particle = scene.particles[i];
  if (particle.fixed) return 0.0;
  double twice = frame.velocity[i].squaredNorm();
  const double radius = particle.diameter / 2.0;
  if (!frame.angular_velocity.empty())
    twice += 0.4 * radius * radius * frame.angular_velocity[i].squaredNorm();
  return 0.5 * mass_of(scene, particle) * twice;
}

double energy_of_overlaps(const Scene& scene, const Frame& frame, Share share, ContactCount* contacts) {
  double sum = 0.0;
  each_contact(scene, frame, [&](std::size_t i, std::int64_t other, double overlap) {
    const Particle& one = scene.particles[i];
    double radius = one.diameter / 2.0;
    const bool wall = other < 0;
    if (contacts != nullptr) (wall ? contacts->walls : contacts->pairs) += 1;
    const auto partner = static_cast<std::size_t>(wall ? -1 - other : other);
    const auto b =
        static_cast<std::size_t>(wall ? scene.walls[partner].material : scene.particles[partner].material);
    if (!wall)
      radius *= scene.particles[partner].diameter / (one.diameter + scene.particles[partner].diameter);
    const auto a = static_cast<std::size_t>(one.material);
    if (!scene.contacts.has(a, b)) return;
    const ContactLaws& laws = scene.contacts.at(a, b);
    sum += share(laws) * in_spring(scene, laws, {a, b}, radius, overlap);
  });
  return sum;
}

Energies energies_of(const Scene& scene, const Frame& frame, ContactCount& contacts) {
  Energies energies;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    energies.kinetic += kinetic_energy(scene, frame, i);
  energies.elastic = energy_of_overlaps(
      scene, frame, [](const ContactLaws&) { return 1.0; }, &contacts);
  energies.gravitational = gravitational(scene, frame);
  return energies;
}

Energies energies_of(const Scene& scene, const Frame& frame) {
  ContactCount ignored;
  return energies_of(scene, frame, ignored);
}

}  // namespace grainproof::report
