// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/one_on_wall.hpp"

#include <cmath>

#include "analytic/contact_scales.hpp"

namespace grainproof::analytic {

std::string why_not_one_on_wall(const Scene& scene) {
  if (scene.particles.size() != 1 || scene.walls.size() != 1) return "there is not one particle and one wall";
  const Particle& sphere = scene.particles.front();
  if (sphere.fixed) return "nothing moves";
  if (!std::holds_alternative<NoFlow>(scene.flow)) return "a fluid acts on the particle";
  if (!std::holds_alternative<ConstantGravity>(scene.gravity)) return "gravity is not constant";
  if (scene.orientation != OrientationUpdate::none) return "orientations are asked for";
  if (!scene.contacts.has(sphere.material, scene.walls.front().material))
    return "the sphere and the wall have no contact laws";
  const ContactLaws& laws = laws_on_wall(scene);
  if (!std::holds_alternative<LinearNormal>(laws.normal)) return "the contact is not linear";
  return std::holds_alternative<NoCohesion>(laws.cohesion) ? "" : "cohesion acts";
}

const ContactLaws& laws_on_wall(const Scene& scene) {
  return scene.contacts.at(scene.particles.at(0).material, scene.walls.at(0).material);
}

double mass_on_wall(const Scene& scene) {
  const Particle& sphere = scene.particles.at(0);
  return sphere_mass(scene.materials[sphere.material].density, sphere.diameter);
}

std::string why_not_at_rest(const Scene& scene, double push, double overlap) {
  constexpr double roundoff = 1e-9;  // of overlaps that are written in decimals
  const double rest = push / std::get<LinearNormal>(laws_on_wall(scene).normal).stiffness;
  return std::abs(overlap - rest) > roundoff * rest ? "the sphere doesn't start at its resting overlap" : "";
}

}  // namespace grainproof::analytic
