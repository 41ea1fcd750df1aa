// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/bulk.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include "comparisons/metrics/bed.hpp"
#include "comparisons/metrics/curves.hpp"
#include "comparisons/metrics/mass.hpp"
#include "comparisons/metrics/touching.hpp"

namespace grainproof {
namespace {

/// Volume of the part of a sphere that is below a height over its centre.
double volume_below(double height, double radius) {
  const double h = std::clamp(height + radius, 0.0, 2.0 * radius);
  return std::numbers::pi * h * h * (radius - h / 3.0);
}

double compliance(const Elasticity& of) {
  return (1.0 - of.poisson_ratio * of.poisson_ratio) / of.youngs_modulus;
}

struct ElasticForce {
  double overlap;
  double radius;  ///< effective
  Elasticity one, two;

  double operator()(const LinearNormal& law) const { return law.stiffness * overlap; }
  double operator()(const HertzNormal&) const {
    return 4.0 / 3.0 / (compliance(one) + compliance(two)) * std::sqrt(radius * overlap) * overlap;
  }
};

/// docs/laws/linear.md, hertz.md; at a wall the effective radius is the particle's.
double elastic_force(const Scene& scene, const Frame& frame, const Pair& pair) {
  const Particle& body = scene.particles[pair.second];
  const double r = 0.5 * body.diameter;
  const auto own = static_cast<std::size_t>(body.material);
  const auto other = static_cast<std::size_t>(pair.first ? scene.particles[*pair.first].material
                                                         : scene.walls[pair.wall].material);
  const double partner = pair.first ? 0.5 * scene.particles[*pair.first].diameter : 0.0;
  const auto elasticity = [&](std::size_t of) {
    return scene.materials[of].elasticity.value_or(Elasticity{1.0, 0.0});
  };
  const ElasticForce force{-gap(scene, frame, pair), pair.first ? r * partner / (r + partner) : r,
                           elasticity(own), elasticity(other)};
  return std::visit(force, scene.contacts.at(own, other).normal);
}

/// A bed that has come down bounces as a whole for long after: a single frame tells the phase of that.
std::vector<double> elastic_forces(const Scene& scene, const Observations& seen) {
  std::vector<double> forces;
  for (const Frame& frame : second_half(seen))
    for (const auto& pairs : {touching_particles(scene, frame), touching_walls(scene, frame)})
      for (const Pair& pair : pairs) forces.push_back(elastic_force(scene, frame, pair));
  return forces;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

constexpr const char* nothing_touches = "nothing touches in the second half of the frames";

/// Height of the lowest rectangle that gravity goes through.
std::optional<double> orifice_height(const Scene& scene, const Vec3& upwards) {
  std::optional<double> lowest;
  for (const Wall& wall : scene.walls) {
    const auto* flat = std::get_if<Rectangle>(&wall.shape);
    if (!flat || (flat->upper - flat->lower).dot(upwards) != 0.0) continue;
    const double height = flat->lower.dot(upwards);
    if (!lowest || height < *lowest) lowest = height;
  }
  return lowest;
}

/// (mass below a height, all mass)
std::pair<double, double> mass_below(const Scene& scene, const Frame& frame, const Vec3& upwards,
                                     double height) {
  double below = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double mass = mass_of(scene, scene.particles[i]);
    all += mass;
    if (frame.position[i].dot(upwards) < height) below += mass;
  }
  return {below, all};
}

/// Least squares.
double slope(const std::vector<std::pair<double, double>>& points) {
  const auto count = static_cast<double>(points.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [time, value] : points) {
    x += time / count;
    y += value / count;
  }
  for (const auto& [time, value] : points) {
    xx += (time - x) * (time - x);
    xy += (time - x) * (value - y);
  }
  return xy / xx;
}

Vec3 centre_of_mass(const Scene& scene, const Frame& frame) {
  Vec3 moment = Vec3::Zero();
  double all = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    moment += mass_of(scene, scene.particles[i]) * frame.position[i];
    all += mass_of(scene, scene.particles[i]);
  }
  return moment / all;
}

const Cylinder* drum(const Scene& scene) {
  for (const Wall& wall : scene.walls)
    if (const auto* cylinder = std::get_if<Cylinder>(&wall.shape)) return cylinder;
  return nullptr;
}

}  // namespace

Measured mean_kinetic_energy(const Scene& scene, const Observations& seen) {
  double sum = 0.0;
  for (const Frame& frame : seen.frames) sum += kinetic_energy(scene, frame);
  return Measured::of(sum / static_cast<double>(seen.frames.size()));
}

Measured packing_of(const Scene& scene, const Observations& seen, int third) {
  const Vec3 upwards = up(scene);
  if (upwards.cwiseAbs().maxCoeff() != 1.0) return Measured::none("gravity is not along an axis");
  const double height = bed_height(scene, seen).value / 3.0;
  const double bottom = floor_of(scene.domain, upwards) + third * height;
  double solid = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double centre = seen.frames.back().position[i].dot(upwards);
    const double radius = 0.5 * scene.particles[i].diameter;
    solid += volume_below(bottom + height - centre, radius) - volume_below(bottom - centre, radius);
  }
  const Vec3 extent = scene.domain.extent();
  const double area = extent.prod() / std::abs(extent.dot(upwards));
  return Measured::of(solid / (area * height));
}

Measured contact_force(const Scene& scene, const Observations& seen) {
  const std::vector<double> forces = elastic_forces(scene, seen);
  return forces.empty() ? Measured::none(nothing_touches) : Measured::of(mean(forces));
}

Measured contact_force_spread(const Scene& scene, const Observations& seen) {
  const std::vector<double> forces = elastic_forces(scene, seen);
  if (forces.empty()) return Measured::none(nothing_touches);
  const double middle = mean(forces);
  double squares = 0.0;
  for (const double force : forces) squares += (force - middle) * (force - middle);
  return Measured::of(std::sqrt(squares / static_cast<double>(forces.size())) / middle);
}

Measured discharge_rate(const Scene& scene, const Observations& seen) {
  const Vec3 upwards = up(scene);
  const auto height = orifice_height(scene, upwards);
  if (!height) return Measured::none("the scene has no rectangle across gravity to fall through");
  std::vector<std::pair<double, double>> points;
  for (const Frame& frame : seen.frames) {
    const auto [below, all] = mass_below(scene, frame, upwards, *height);
    if (below > 0.05 * all && below < 0.6 * all) points.emplace_back(frame.time, below);
  }
  if (points.size() < 3) return Measured::none("fewer than three frames between 5 and 60 % discharged");
  return Measured::of(slope(points));
}

Measured slope_angle(const Scene& scene, const Observations& seen) {
  const Cylinder* cylinder = drum(scene);
  if (!cylinder) return Measured::none("the scene has no cylinder");
  const Vec3 down = -up(scene);
  const std::span<const Frame> frames = second_half(seen);
  double sum = 0.0;
  for (const Frame& frame : frames) {
    Vec3 way = centre_of_mass(scene, frame) - cylinder->point;
    way -= way.dot(cylinder->axis) * cylinder->axis;
    sum += std::atan2(down.cross(way).dot(cylinder->axis), down.dot(way));
  }
  return Measured::of(sum / static_cast<double>(frames.size()));
}

}  // namespace grainproof
