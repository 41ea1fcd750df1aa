// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/supports.hpp"

#include <array>
#include <sstream>
#include <string>

#include "reference_cpu/bodies.hpp"

namespace grainproof::reference {
namespace {

constexpr std::array<char, 3> axis_names{'x', 'y', 'z'};

/// A pair may touch through one image only, so a period holds two of the largest ranges.
Support periods_hold_two_ranges(const Scene& scene) {
  const double range = 2.0 * largest_reach(scene);
  for (int axis = 0; axis < 3; ++axis) {
    const double period = scene.domain.extent()[axis];
    if (!scene.domain.periodic(axis) || period >= 2.0 * range) continue;
    std::ostringstream why;
    why << "the periodic box is too small for its particles: " << period << " m along " << axis_names[axis]
        << "; it must be at least " << 2.0 * range << " m, twice the range of the largest pair";
    return Support::no(why.str());
  }
  return {};
}

/// A plane has no image of itself that fits; a rectangle either spans the period or leaves room.
bool fits_period(const Plane& plane, int axis, double, double) {
  return plane.normal[axis] == 0.0;
}

bool fits_period(const Rectangle& rectangle, int axis, double period, double range) {
  const double length = rectangle.upper[axis] - rectangle.lower[axis];
  return length >= period || period - length >= range;
}

bool fits_period(const Cylinder& cylinder, int axis, double, double) {
  return cylinder.axis.cwiseAbs() == Vec3::Unit(axis);
}

Support walls_fit_periods(const Scene& scene) {
  const double range = 2.0 * largest_reach(scene);
  for (const Wall& wall : scene.walls)
    for (int axis = 0; axis < 3; ++axis) {
      if (!scene.domain.periodic(axis)) continue;
      const double period = scene.domain.extent()[axis];
      if (std::visit([&](const auto& shape) { return fits_period(shape, axis, period, range); }, wall.shape))
        continue;
      return Support::no("the wall '" + wall.name + "' does not fit the periodic " + axis_names[axis] +
                         " axis: a plane must lie along it, a cylinder's axis be parallel to it, a rectangle "
                         "span it or leave a gap as wide as the largest particle");
    }
  return {};
}

Support fixed_particles_rest(const Scene& scene) {
  for (const Particle& particle : scene.particles)
    if (particle.fixed && (particle.velocity != Vec3::Zero() || particle.angular_velocity != Vec3::Zero()))
      return Support::no("the fixed particle " + std::to_string(particle.id) + " has a velocity");
  return {};
}

/// Fixed particles and walls never meet each other, but are asked for all the same: simpler to say.
/// How many particles of one material there are, and how many of them move.
struct Population {
  int all = 0;
  int moving = 0;
};

std::vector<Population> populations(const Scene& scene) {
  std::vector<Population> of(scene.materials.size());
  for (const Particle& particle : scene.particles) {
    ++of[particle.material].all;
    if (!particle.fixed) ++of[particle.material].moving;
  }
  return of;
}

bool can_meet(const std::vector<Population>& of, std::size_t a, std::size_t b) {
  if (a == b) return of[a].all > 1 && of[a].moving > 0;
  return of[a].all > 0 && of[b].all > 0 && of[a].moving + of[b].moving > 0;
}

Support laws_are_given(const Scene& scene) {
  const std::vector<Population> of = populations(scene);
  const auto missing = [&](std::size_t a, std::size_t b) {
    return Support::no("no contact laws between the materials '" + scene.materials[a].name + "' and '" +
                       scene.materials[b].name + "'");
  };
  for (std::size_t a = 0; a < of.size(); ++a) {
    for (std::size_t b = a; b < of.size(); ++b)
      if (can_meet(of, a, b) && !scene.contacts.has(a, b)) return missing(a, b);
    for (const Wall& wall : scene.walls)
      if (of[a].moving > 0 && !scene.contacts.has(a, wall.material)) return missing(a, wall.material);
  }
  return {};
}

Support restitutions_are_reachable(const Scene& scene) {
  const std::size_t materials = scene.contacts.materials();
  for (std::size_t a = 0; a < materials; ++a)
    for (std::size_t b = a; b < materials; ++b) {
      if (!scene.contacts.has(a, b)) continue;
      const auto* law = std::get_if<LinearNormal>(&scene.contacts.at(a, b).normal);
      if (!law || !law->no_tension) continue;
      const auto* restitution = std::get_if<Restitution>(&law->dissipation);
      if (restitution && restitution->value == 0.0)
        return Support::no("a contact that never pulls cannot rebound with restitution 0");
    }
  return {};
}

Support turning_is_asked_for(const Scene& scene) {
  if (scene.rotation) return {};
  for (const Particle& particle : scene.particles)
    if (particle.angular_velocity != Vec3::Zero())
      return Support::no("particle " + std::to_string(particle.id) +
                         " has an angular velocity in a scene without rotation");
  return {};
}

/// What a spring is to be made of must be there.
Support springs_are_given(const Scene& scene, std::size_t a, std::size_t b) {
  const ContactLaws& laws = scene.contacts.at(a, b);
  const bool hertz = std::holds_alternative<HertzNormal>(laws.normal);
  const auto* history = std::get_if<HistoryFriction>(&laws.friction);
  if (!std::holds_alternative<NoRolling>(laws.rolling))
    return Support::no("rolling resistance is not built in");
  if (history && history->memory == SpringMemory::force)
    return Support::no("a tangential spring that remembers its force is not built in");
  if (!hertz && history && !(history->stiffness > 0.0))
    return Support::no("friction with history on a linear contact needs a tangential stiffness above zero");
  if (!hertz) return {};
  for (const std::size_t material : {a, b})
    if (!scene.materials[material].elasticity)
      return Support::no("a Hertz contact needs the elasticity of '" + scene.materials[material].name + "'");
  const auto* restitution = std::get_if<Restitution>(&std::get<HertzNormal>(laws.normal).dissipation);
  if (!restitution || restitution->value == 0.0)
    return Support::no("a Hertz contact takes its damping from a restitution only, and one above 0");
  if (std::holds_alternative<CollisionTimeFriction>(laws.friction) ||
      std::holds_alternative<DampedFriction>(laws.friction))
    return Support::no("this friction needs the contact time of a linear spring, which Hertz contacts lack");
  return {};
}

Support all_springs_are_given(const Scene& scene) {
  const std::size_t materials = scene.contacts.materials();
  for (std::size_t a = 0; a < materials; ++a)
    for (std::size_t b = a; b < materials; ++b)
      if (scene.contacts.has(a, b))
        if (const Support support = springs_are_given(scene, a, b); !support) return support;
  return {};
}

Support nothing_else_is_asked_for(const Scene& scene) {
  for (const Wall& wall : scene.walls)
    if (!std::holds_alternative<Still>(wall.motion))
      return Support::no("the wall '" + wall.name + "' moves, which is not built in");
  if (scene.orientation != OrientationUpdate::none) return Support::no("orientations are not built in");
  if (!scene.remembered.empty()) return Support::no("contacts that remember are not built in");
  return {};
}

}  // namespace

Support supported(const Scene& scene) {
  for (const auto& check :
       {laws_are_given, periods_hold_two_ranges, walls_fit_periods, fixed_particles_rest,
        turning_is_asked_for, all_springs_are_given, restitutions_are_reachable, nothing_else_is_asked_for})
    if (const Support support = check(scene); !support) return support;
  return {};
}

}  // namespace grainproof::reference
