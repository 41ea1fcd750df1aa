// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/crowd.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace grainproof::analytic {
namespace {

/// Equal spheres about one: twelve; about each pole of a line one and five around it at 60°, that is
/// 2 (1 + 5/4) along the line, and 1 + 5/2 for one pole alone.
constexpr double kissing_number = 12.0;
constexpr double most_along = 4.5;
constexpr double most_resultant = 3.5;
/// Found by search, twelve leaning towards a plane: 8.54.
constexpr double most_across = 8.6;

/// Spheres of the smallest diameter that find room about one: their caps do not overlap.
double room_about(const Scene& scene, double diameter) {
  double smallest = diameter;
  for (const Particle& particle : scene.particles) smallest = std::min(smallest, particle.diameter);
  if (smallest == diameter) return kissing_number;
  const double sine = smallest / (smallest + diameter);
  return std::max(kissing_number, std::floor(2.0 / (1.0 - std::sqrt(1.0 - sine * sine))));
}

struct Face {
  Vec3 normal;
  double offset;
};

/// Two parallel faces are both touched only where a sphere fills the gap between them.
bool exclude_each_other(const Face& one, const Face& other, double diameter) {
  const double cosine = one.normal.dot(other.normal);
  if (std::abs(cosine) < 1.0 - 1e-12) return false;
  return std::abs(one.offset - std::copysign(other.offset, cosine * other.offset)) > diameter;
}

struct Walls {
  std::vector<Face> faces;  ///< no two of which exclude each other
  int curved = 0;           ///< touched from any side
};

Walls walls_at_once(const Scene& scene, double diameter) {
  Walls walls;
  const auto add = [&](const Vec3& normal, const Vec3& point) {
    const Face face{normal, normal.dot(point)};
    if (std::ranges::none_of(walls.faces,
                             [&](const Face& one) { return exclude_each_other(one, face, diameter); }))
      walls.faces.push_back(face);
  };
  for (const Wall& wall : scene.walls)
    std::visit(Overloaded{[&](const Plane& plane) { add(plane.normal, plane.point); },
                          [&](const Rectangle& flat) {
                            int axis = 0;
                            while (flat.upper[axis] != flat.lower[axis]) ++axis;
                            add(Vec3::Unit(axis), flat.lower);
                          },
                          [&](const Cylinder&) { ++walls.curved; }},
               wall.shape);
  return walls;
}

double largest_along(const Walls& walls) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Face& face : walls.faces) sum += face.normal * face.normal.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvalues().maxCoeff() + walls.curved;
}

}  // namespace

Crowd crowd_of(const Scene& scene, double diameter) {
  const double room = room_about(scene, diameter), scale = room / kissing_number;
  const double spheres = std::min(static_cast<double>(scene.particles.size()) - 1.0, room);
  const Walls walls = walls_at_once(scene, diameter);
  const double on_walls = static_cast<double>(walls.faces.size()) + walls.curved;
  const double contacts = std::min(spheres + on_walls, std::max(room, on_walls));
  const double along_walls = largest_along(walls);
  return {contacts, std::min(spheres + along_walls, std::max(most_along * scale, along_walls)),
          std::min(contacts, std::max(most_across * scale, on_walls)),
          std::min(contacts, std::max(most_resultant * scale, on_walls))};
}

}  // namespace grainproof::analytic
