// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/bed.hpp"

#include "comparisons/metrics/touching.hpp"

namespace grainproof {

std::span<const Frame> second_half(const Observations& seen) {
  return std::span(seen.frames).subspan(seen.frames.size() / 2);
}

Vec3 up(const Scene& scene) {
  const auto* gravity = std::get_if<ConstantGravity>(&scene.gravity);
  return gravity && gravity->acceleration.norm() > 0.0 ? Vec3(-gravity->acceleration.normalized())
                                                       : Vec3::UnitZ();
}

double floor_of(const Domain& domain, const Vec3& upwards) {
  return domain.lower.cwiseProduct(upwards).cwiseMin(domain.upper.cwiseProduct(upwards)).sum();
}

Measured bed_height(const Scene& scene, const Observations& seen) {
  const Vec3 upwards = up(scene);
  const double floor = floor_of(scene.domain, upwards);
  double sum = 0.0;
  for (const Vec3& position : seen.frames.back().position) sum += position.dot(upwards) - floor;
  return Measured::of(2.0 * sum / static_cast<double>(scene.particles.size()));
}

Measured contact_number(const Scene& scene, const Observations& seen) {
  return Measured::of(2.0 * static_cast<double>(touching_particles(scene, seen.frames.back()).size()) /
                      static_cast<double>(scene.particles.size()));
}

Measured mean_contact_number(const Scene& scene, const Observations& seen) {
  std::size_t pairs = 0;
  for (const Frame& frame : second_half(seen)) pairs += touching_particles(scene, frame).size();
  return Measured::of(2.0 * static_cast<double>(pairs) /
                      static_cast<double>(second_half(seen).size() * scene.particles.size()));
}

}  // namespace grainproof
