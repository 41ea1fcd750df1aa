// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "opencl/limits.hpp"
#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

const Particle* particle_of(const Scene& scene, std::int64_t id) {
  const auto found = std::ranges::lower_bound(scene.particles, id, {}, &Particle::id);
  return found != scene.particles.end() && found->id == id ? &*found : nullptr;
}

Vec3 nearest_image(Vec3 across, const Domain& domain) {
  for (int axis = 0; axis < 3; ++axis) {
    const double period = domain.extent()[axis];
    if (domain.periodic(axis)) across[axis] -= period * std::round(across[axis] / period);
  }
  return across;
}

double distance_to(const Plane& plane, const Vec3& x, const Domain&) {
  return (x - plane.point).dot(plane.normal);
}

double distance_to(const Rectangle& r, const Vec3& x, const Domain& domain) {
  const Vec3 half = (r.upper - r.lower) / 2;
  const Vec3 across = nearest_image(x - (r.lower + half), domain);
  return (across - across.cwiseMin(half).cwiseMax(-half)).norm();
}

double distance_to(const Cylinder& c, const Vec3& x, const Domain&) {
  const Vec3 across = x - c.point;
  const double from_surface = (across - across.dot(c.axis) * c.axis).norm() - c.radius;
  return c.side == Cylinder::Side::inside ? -from_surface : from_surface;
}

/// The second of a remembered contact.
struct Partner {
  double gap;  ///< m
  std::int32_t material;
  bool moves;
};

Partner partner_of(const Scene& scene, const ContactMemory& memory, const Particle& first) {
  if (memory.second >= 0) {
    const Particle& second = *particle_of(scene, memory.second);
    const Vec3 across = nearest_image(second.position - first.position, scene.domain);
    return {across.norm() - (first.diameter + second.diameter) / 2, second.material, !second.fixed};
  }
  const Wall& wall = scene.walls[static_cast<std::size_t>(-1 - memory.second)];
  const double distance = std::visit(
      [&](const auto& shape) { return distance_to(shape, first.position, scene.domain); }, wall.shape);
  return {distance - first.diameter / 2, wall.material, false};
}

bool both_there(const Scene& scene, const ContactMemory& memory) {
  if (particle_of(scene, memory.first) == nullptr) return false;
  if (memory.second >= 0) return memory.second > memory.first && particle_of(scene, memory.second) != nullptr;
  return -1 - memory.second < static_cast<std::int64_t>(scene.walls.size());
}

bool kept_by(const ContactLaws& laws, const ContactMemory& memory) {
  const auto* history = std::get_if<HistoryFriction>(&laws.friction);
  const bool winds = std::holds_alternative<SpringRolling>(laws.rolling);
  const bool overlap = history != nullptr && history->memory == SpringMemory::force;
  return memory.feature == 0 && history != nullptr && (winds || memory.rolling_torque.isZero(0.0)) &&
         (overlap || memory.overlap == 0.0);
}

}  // namespace

Support memory_within_limits(const ContactMemory& memory, const Scene& scene) {
  const std::string contact =
      "the contact of " + std::to_string(memory.first) + " and " + std::to_string(memory.second);
  if (!both_there(scene, memory)) return Support::no(contact + " is remembered but not both are there");
  const Particle& first = *particle_of(scene, memory.first);
  const Partner second = partner_of(scene, memory, first);
  if (first.fixed && !second.moves) return Support::no(contact + " is remembered but neither of them moves");
  if (!(second.gap < 0.0)) return Support::no(contact + " is remembered but they do not touch at the start");
  const auto a = static_cast<std::size_t>(first.material), b = static_cast<std::size_t>(second.material);
  if (!scene.contacts.has(a, b) || !kept_by(scene.contacts.at(a, b), memory))
    return Support::no(contact + " remembers what its laws do not keep");
  return {};
}

}  // namespace grainproof::opencl
