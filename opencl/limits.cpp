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

Support what_turns_is_asked_for(const Scene& scene) {
  if (scene.rotation) return {};
  if (scene.orientation != OrientationUpdate::none)
    return Support::no("orientations need a scene with rotation");
  for (std::size_t a = 0; a < scene.materials.size(); ++a)
    for (std::size_t b = 0; b < scene.materials.size(); ++b)
      if (scene.contacts.has(a, b) && !std::holds_alternative<NoRolling>(scene.contacts.at(a, b).rolling))
        return Support::no("rolling resistance needs a scene with rotation");
  return {};
}

Support walls_and_memories(const Scene& scene, Precision precision) {
  for (const Wall& wall : scene.walls)
    if (const Support support = wall_within_limits(wall, scene, precision); !support) return support;
  for (const ContactMemory& memory : scene.remembered)
    if (const Support support = memory_within_limits(memory, scene); !support) return support;
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
  if (const Support turns = what_turns_is_asked_for(scene); !turns) return turns;
  if (const Support still = fixed_do_not_spin(scene); !still) return still;
  if (const Support wide = periodic_box_wide_enough(scene, reach); !wide) return wide;
  if (const Support laws = laws_complete(scene); !laws) return laws;
  return walls_and_memories(scene, precision);
}

}  // namespace grainproof::opencl
