// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/limits.hpp"

#include "model/errors.hpp"
#include "opencl/near_walls.hpp"
#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

bool inside(const Vec3& x, const Domain& domain) {
  return (x.array() >= domain.lower.array()).all() && (x.array() <= domain.upper.array()).all();
}

Support periodic_box_wide_enough(const Scene& scene, double reach) {
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.periodic(axis) && scene.domain.extent()[axis] < 4.0 * reach)
      return Support::no(
          "the box is periodic and shorter than two effect diameters, so a pair could meet twice");
  return {};
}

Support laws_complete(const Scene& scene) {
  std::vector<char> used(scene.materials.size());
  for (const Particle& p : scene.particles) used[static_cast<std::size_t>(p.material)] = 1;
  for (const Wall& wall : scene.walls) used[static_cast<std::size_t>(wall.material)] = 1;
  for (std::size_t a = 0; a < used.size(); ++a)
    for (std::size_t b = 0; b < used.size(); ++b) {
      if (!used[a] || !used[b] || !scene.contacts.has(a, b)) continue;
      try {
        coefficients_of(scene, a, b);
      } catch (const InputRefused& refused) {
        return Support::no(refused.what());
      }
    }
  return {};
}

/// What a scene may ask for and no kernel does yet.
Support everything_built(const Scene& scene) {
  for (const Wall& wall : scene.walls) {
    if (std::holds_alternative<Cylinder>(wall.shape)) return Support::no("cylinder walls are not built yet");
    if (!std::holds_alternative<Still>(wall.motion)) return Support::no("moving walls are not built yet");
  }
  if (scene.orientation != OrientationUpdate::none) return Support::no("orientations are not built yet");
  if (!scene.remembered.empty()) return Support::no("contacts that remember at the start are not built yet");
  for (std::size_t a = 0; a < scene.materials.size(); ++a)
    for (std::size_t b = 0; b < scene.materials.size(); ++b) {
      if (!scene.contacts.has(a, b)) continue;
      const ContactLaws& laws = scene.contacts.at(a, b);
      if (!std::holds_alternative<NoRolling>(laws.rolling))
        return Support::no("rolling resistance is not built yet");
      const auto* history = std::get_if<HistoryFriction>(&laws.friction);
      if (history != nullptr && history->memory == SpringMemory::force)
        return Support::no("springs that keep their force are not built yet");
    }
  return {};
}

/// A mass without bounds that turns has no meaning in the equations of motion.
Support fixed_do_not_spin(const Scene& scene) {
  for (const Particle& p : scene.particles)
    if (p.fixed && scene.rotation && !p.angular_velocity.isZero(0.0))
      return Support::no("particle " + std::to_string(p.id) + " is fixed and spins");
  return {};
}

}  // namespace

Support within_limits(const Scene& scene, Precision precision) {
  if (scene.particles.size() >= 100'000'000) return Support::no("100 million particles or more");
  for (const Particle& p : scene.particles)
    if (!inside(p.position, scene.domain))
      return Support::no("particle " + std::to_string(p.id) + " is outside the domain");
  const double reach = largest_reach(scene);
  const double longest = scene.domain.extent().maxCoeff();
  if (precision == Precision::single_precision && 2.0 * reach > longest)
    return Support::no("a particle is larger than the domain, which single precision measures positions by");
  if (const auto* central = std::get_if<CentralGravity>(&scene.gravity))
    if (precision == Precision::single_precision && !inside(central->centre, scene.domain))
      return Support::no(
          "the centre of gravity is outside the domain, by which single precision measures positions");
  if (const Support built = everything_built(scene); !built) return built;
  if (const Support still = fixed_do_not_spin(scene); !still) return still;
  if (const Support wide = periodic_box_wide_enough(scene, reach); !wide) return wide;
  return laws_complete(scene);
}

}  // namespace grainproof::opencl
