// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "opencl/coordinates.hpp"

namespace grainproof::opencl {
namespace {

cl_double4 four(const Vec3& v, double w = 0.0) {
  return {{v[0], v[1], v[2], w}};
}

}  // namespace

// A scene around zero keeps its own coordinates, so that numbers given exactly stay exact; one that lies far
// away is measured from its corner, so that its digits are not spent on the distance.
Coordinates<Double>::Coordinates(const Domain& domain) : origin_(Vec3::Zero()) {
  for (int axis = 0; axis < 3; ++axis)
    if (domain.lower[axis] > 0.0 || domain.upper[axis] < 0.0) origin_[axis] = domain.lower[axis];
}

Double::Position Coordinates<Double>::position(const Vec3& at, double radius) const {
  return {four(at - origin_, radius)};
}

Vec3 Coordinates<Double>::metres(const Double::Position& p) const {
  return origin_ + Vec3(p.at.s[0], p.at.s[1], p.at.s[2]);
}

Double::Box Coordinates<Double>::box(const Domain& domain, const std::array<int, 3>& zones,
                                     double skin) const {
  Double::Box box{};
  box.lower = four(domain.lower - origin_);
  box.upper = four(domain.upper - origin_);
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = domain.extent()[axis];
    box.period.s[axis] = domain.periodic(axis) ? extent : 0.0;
    box.half_period.s[axis] = domain.periodic(axis) ? extent / 2 : std::numeric_limits<double>::max();
    box.zone_scale.s[axis] = zones[axis] / extent;
    box.zones.s[axis] = zones[axis];
  }
  box.skin = skin;
  box.half_skin = skin / 2;
  return box;
}

Vec3 Coordinates<Double>::held_at(const Plane& wall, const Domain&) const {
  return wall.point;
}

Vec3 Coordinates<Double>::held_at(const Cylinder& wall, const Domain&) const {
  return wall.point;
}

Double::PlaneShape Coordinates<Double>::plane(const Plane& wall, const Domain& domain) const {
  return {four(held_at(wall, domain) - origin_), four(wall.normal)};
}

Double::CylinderShape Coordinates<Double>::cylinder(const Cylinder& wall, const Domain& domain) const {
  const auto [one, two] = across(wall.axis);
  return {{plane({wall.point, one}, domain), plane({wall.point, two}, domain)}, wall.radius};
}

Double::RectangleShape Coordinates<Double>::rectangle(const Rectangle& wall) const {
  const Vec3 half = (wall.upper - wall.lower) / 2;
  return {position(wall.lower + half), four(half)};
}

Double::Wave Coordinates<Double>::wave(double wave_number) const {
  return {four(origin_), four(Vec3::Constant(wave_number))};
}

}  // namespace grainproof::opencl
