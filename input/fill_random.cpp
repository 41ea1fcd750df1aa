// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/fills.hpp"
#include "input/sphere_grid.hpp"

namespace grainproof::input {
namespace {

struct Region {
  Vec3 lower;
  Vec3 upper;
};

/// Where no region is given: the domain, a radius away from every face that is not periodic.
Region read_region(const Table& table, const Domain& domain, double radius) {
  Region region{domain.lower, domain.upper};
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.periodic(axis)) continue;
    region.lower[axis] += radius;
    region.upper[axis] -= radius;
  }
  if (const auto lower = table.find("lower")) region.lower = lower->vector();
  if (const auto upper = table.find("upper")) region.upper = upper->vector();
  if (!(region.lower.array() <= region.upper.array()).all())
    table.whole().refuse("a region with lower above upper", "room for particles");
  return region;
}

/// Puts spheres down one after the other wherever they touch nothing (random sequential addition).
class Placer {
 public:
  /// `diameter`: of the largest that will be placed.
  Placer(const Scene& scene, double diameter, double gap, std::size_t count)
      : scene_(scene),
        gap_(gap),
        reach_(largest_diameter(scene, diameter) + gap),
        grid_(scene.domain, reach_, count + scene.particles.size()) {
    for (const Particle& particle : scene.particles) add(particle.position, 0.5 * particle.diameter);
  }

  bool try_place(const Vec3& position, double radius) {
    for (const Wall& wall : scene_.walls)
      if (distance_to(wall.shape, position) < radius + gap_) return false;
    if (hits(position, radius)) return false;
    add(position, radius);
    return true;
  }

 private:
  static double largest_diameter(const Scene& scene, double diameter) {
    for (const Particle& particle : scene.particles) diameter = std::max(diameter, particle.diameter);
    return diameter;
  }

  bool hits(const Vec3& position, double radius) const {
    return grid_.any_near(position, [&](std::size_t other) {
      const double apart = nearest_image(scene_.domain, positions_[other], position).norm();
      return apart < radius + radii_[other] + gap_;
    });
  }

  void add(const Vec3& position, double radius) {
    grid_.insert(positions_.size(), position);
    positions_.push_back(position);
    radii_.push_back(radius);
  }

  const Scene& scene_;
  double gap_;
  double reach_;
  SphereGrid grid_;
  std::vector<Vec3> positions_;
  std::vector<double> radii_;
};

constexpr int most_attempts = 1000;

bool place_one(Placer& placer, const Region& region, double diameter, Uniform& uniform,
               std::vector<Filled>& filled) {
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    Vec3 position;
    for (int axis = 0; axis < 3; ++axis)
      position[axis] = region.lower[axis] + uniform() * (region.upper[axis] - region.lower[axis]);
    if (!placer.try_place(position, 0.5 * diameter)) continue;
    filled.push_back({position, {}, {}, Vec3::Zero(), diameter});
    return true;
  }
  return false;
}

}  // namespace

std::vector<Filled> fill_random(const Table& table, Diameters& diameters, const Scene& scene,
                                std::size_t largest) {
  table.only({"kind", "count", "lower", "upper", "gap", "seed"});
  const Node count_node = table.at("count");
  const auto count =
      static_cast<std::size_t>(count_node.integer_within(1, static_cast<std::int64_t>(largest)));
  const Region region = read_region(table, scene.domain, 0.5 * diameters.most());
  const auto gap = table.find("gap");
  Placer placer(scene, diameters.most(), gap ? gap->not_negative() : 0.0, count);
  Uniform uniform(table.at("seed").seed());
  std::vector<Filled> filled;
  while (filled.size() < count)
    if (!place_one(placer, region, diameters.next(), uniform, filled))
      count_node.refuse(count_node.described() + " particles that don't fit: after " +
                            std::to_string(filled.size()) + " no place was found in " +
                            std::to_string(most_attempts) + " attempts",
                        "fewer particles or a larger region");
  return filled;
}

}  // namespace grainproof::input
