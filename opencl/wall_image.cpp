// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/wall_image.hpp"

#include <cmath>
#include <numbers>

#include "opencl/bytes.hpp"
#include "opencl/coordinates.hpp"

namespace grainproof::opencl {
namespace {

struct Place {
  Vec3 shift = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
};

/// docs/laws/walls.md
Place place_at(const WallMotion& motion, double time) {
  if (const auto* translating = std::get_if<Translating>(&motion))
    return {translating->velocity * time, translating->velocity};
  const auto* vibrating = std::get_if<Vibrating>(&motion);
  if (vibrating == nullptr) return {};
  const double rate = 2.0 * std::numbers::pi * vibrating->frequency;
  const double phase = rate * time + vibrating->phase;
  return {vibrating->amplitude * (std::sin(phase) - std::sin(vibrating->phase)),
          vibrating->amplitude * (rate * std::cos(phase))};
}

Plane shifted(const Plane& plane, const Vec3& by) {
  return {plane.point + by, plane.normal};
}
Rectangle shifted(const Rectangle& r, const Vec3& by) {
  return {r.lower + by, r.upper + by};
}
Cylinder shifted(const Cylinder& c, const Vec3& by) {
  return {c.point + by, c.axis, c.radius, c.side};
}

Vec3 axis_of(const Plane& plane) {
  return plane.normal;
}
Vec3 axis_of(const Rectangle&) {
  return Vec3::Zero();
}
Vec3 axis_of(const Cylinder& cylinder) {
  return cylinder.axis;
}

cl_int inside_of(const Cylinder& cylinder) {
  return cylinder.side == Cylinder::Side::inside ? 1 : 0;
}
template <class Shape>
cl_int inside_of(const Shape&) {
  return 0;
}

template <class P>
class WallImager {
 public:
  explicit WallImager(const Scene& scene)
      : domain_(scene.domain), coordinates_(scene.domain), reach_(largest_reach(scene)) {}

  WallBytes bytes(const NearWalls& walls) const {
    std::vector<PlaneOf<P>> planes;
    std::vector<RectangleOf<P>> rectangles;
    std::vector<CylinderOf<P>> cylinders;
    for (const auto& w : walls.planes) planes.push_back({coordinates_.plane(w.shape, domain_), surface(w)});
    for (const auto& w : walls.rectangles)
      rectangles.push_back({coordinates_.rectangle(within_reach(w)), surface(w)});
    for (const auto& w : walls.cylinders)
      cylinders.push_back({coordinates_.cylinder(w.shape, domain_), surface(w)});
    return {bytes_of(planes), bytes_of(rectangles), bytes_of(cylinders)};
  }

  template <class Shape>
  Stand<P> stand(const NearWall<Shape>& wall, double time) const {
    const Place place = place_at(wall.motion, time);
    NearWall<Shape> now = wall;
    now.shape = shifted(wall.shape, place.shift);
    Stand<P> stand{};
    stand.shape = held(now);
    stand.velocity = four_of<P>(place.velocity);
    stand.offset = four_of<P>(across_no_face(held_at(now) - wall.reference - place.shift, now));
    return stand;
  }

 private:
  /// A rectangle is held by its image in the domain; its reference point goes with it.
  Vec3 across_no_face(Vec3 offset, const NearWall<Rectangle>& wall) const {
    for (int axis = 0; axis < 3; ++axis)
      if (domain_.periodic(axis)) offset[axis] = (wall.shape.upper[axis] - wall.shape.lower[axis]) / 2;
    return offset;
  }
  template <class Shape>
  Vec3 across_no_face(const Vec3& offset, const NearWall<Shape>&) const {
    return offset;
  }

  /// A rectangle that stays is clipped already.
  Rectangle within_reach(const NearWall<Rectangle>& wall) const {
    return wall.row < 0 ? wall.shape : opencl::within_reach(wall.shape, domain_, reach_);
  }
  Vec3 held_at(const NearWall<Rectangle>& wall) const {
    const Rectangle r = within_reach(wall);
    return (r.lower + r.upper) / 2;
  }
  template <class Shape>
  Vec3 held_at(const NearWall<Shape>& wall) const {
    return coordinates_.held_at(wall.shape, domain_);
  }
  typename P::RectangleShape held(const NearWall<Rectangle>& wall) const {
    return coordinates_.rectangle(within_reach(wall));
  }
  template <class Shape>
  typename P::RectangleShape held(const NearWall<Shape>& wall) const {
    typename P::RectangleShape shape{};
    shape.centre = coordinates_.position(held_at(wall));
    return shape;
  }

  template <class Shape>
  Surface<P> surface(const NearWall<Shape>& wall) const {
    const auto* rotating = std::get_if<Rotating>(&wall.motion);
    const Vec3 spin = rotating != nullptr ? Vec3(rotating->rate * axis_of(wall.shape)) : Vec3::Zero();
    const Vec3 offset = held_at(wall) - wall.reference;
    return {four_of<P>(spin.cross(offset)),
            four_of<P>(spin),
            four_of<P>(offset),
            {{wall.material, wall.index, wall.row, inside_of(wall.shape)}}};
  }

  const Domain& domain_;
  Coordinates<P> coordinates_;
  double reach_;
};

template <class P>
Bytes table_of(const NearWalls& walls, const Scene& scene, std::int64_t first, std::int64_t last) {
  const WallImager<P> imager(scene);
  std::vector<Stand<P>> table;
  if (walls.moving() > 0)
    for (std::int64_t n = first; n <= last; ++n)
      walls.each([&](const auto& wall) {
        if (wall.row >= 0) table.push_back(imager.stand(wall, static_cast<double>(n) * scene.run.step));
      });
  return bytes_of(table);
}

}  // namespace

WallBytes wall_bytes(const NearWalls& walls, const Scene& scene, Precision precision) {
  return with_types_of(precision,
                       [&](auto types) { return WallImager<decltype(types)>(scene).bytes(walls); });
}

Bytes stand_table(const NearWalls& walls, const Scene& scene, std::int64_t first, std::int64_t last,
                  Precision precision) {
  return with_types_of(precision,
                       [&](auto types) { return table_of<decltype(types)>(walls, scene, first, last); });
}

double farthest_shift(const WallMotion& motion, double end) {
  if (const auto* translating = std::get_if<Translating>(&motion)) return translating->velocity.norm() * end;
  if (const auto* vibrating = std::get_if<Vibrating>(&motion)) return 2.0 * vibrating->amplitude.norm();
  return 0.0;
}

std::array<Vec3, 2> across(const Vec3& axis) {
  int most = 0;
  axis.cwiseAbs().maxCoeff(&most);
  const Vec3 aside = Vec3::Unit((most + 1) % 3);
  const Vec3 one = (aside - aside.dot(axis) * axis).normalized();
  return {one, axis.cross(one)};
}

}  // namespace grainproof::opencl
