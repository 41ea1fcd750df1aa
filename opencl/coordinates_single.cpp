// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "opencl/coordinates.hpp"

namespace grainproof::opencl {
namespace {

struct Split {
  cl_int whole;
  cl_float part;
};

Split split(double quanta) {
  const double whole = std::nearbyint(quanta);
  return {static_cast<cl_int>(whole), static_cast<cl_float>(quanta - whole)};
}

/// Fraction of a turn, modulo one, in units of 2^-64.
cl_ulong turn_bits(long double turns) {
  const long double fraction = turns - std::floor(turns);
  return static_cast<cl_ulong>(std::ldexp(fraction, 64));
}

}  // namespace

Coordinates<Single>::Coordinates(const Domain& domain)
    : lower_(domain.lower), quantum_(std::ldexp(domain.extent().maxCoeff(), -30)) {}

Single::Position Coordinates<Single>::position(const Vec3& at, double radius) const {
  Single::Position p{};
  const Vec3 from_corner = at - lower_;
  for (int axis = 0; axis < 4; ++axis) {
    const Split s = split((axis < 3 ? from_corner[axis] : radius) / quantum_);
    p.whole.s[axis] = s.whole;
    p.part.s[axis] = s.part;
  }
  return p;
}

Single::Reach Coordinates<Single>::reach(double length) const {
  const Split s = split(length / quantum_);
  return {s.whole, s.part};
}

Vec3 Coordinates<Single>::metres(const Single::Position& p) const {
  Vec3 at;
  for (int axis = 0; axis < 3; ++axis)
    at[axis] = lower_[axis] + quantum_ * (p.whole.s[axis] + static_cast<double>(p.part.s[axis]));
  return at;
}

Single::Box Coordinates<Single>::box(const Domain& domain, const std::array<int, 3>& zones,
                                     double skin) const {
  Single::Box box{};
  for (int axis = 0; axis < 3; ++axis) {
    const Split extent = split(domain.extent()[axis] / quantum_);
    const bool periodic = domain.periodic(axis);
    box.whole.s[axis] = extent.whole;
    box.part.s[axis] = extent.part;
    box.period.s[axis] = periodic ? extent.whole : 0;
    box.period_part.s[axis] = periodic ? extent.part : 0.0f;
    box.half_period.s[axis] = periodic ? extent.whole / 2 : std::numeric_limits<cl_int>::max();
    const double scale = std::ldexp(static_cast<double>(zones[axis]), 50) / std::max(extent.whole, 1);
    box.zone_scale.s[axis] = static_cast<cl_ulong>(scale);
    box.zones.s[axis] = zones[axis];
  }
  box.quantum.s[0] = static_cast<cl_float>(quantum_);
  box.skin = reach(skin);
  box.half_skin = reach(skin / 2);
  return box;
}

// The point nearest to the middle of the domain, so that differences fit; a plane beyond every particle's
// reach counts as one just there.
Vec3 Coordinates<Single>::held_at(const Plane& wall, const Domain& domain) const {
  const Vec3 middle = (domain.lower + domain.upper) / 2;
  const double farthest = 1.37 * domain.extent().maxCoeff();
  const double height = std::clamp((middle - wall.point).dot(wall.normal), -farthest, farthest);
  return middle - height * wall.normal;
}

Vec3 Coordinates<Single>::held_at(const Cylinder& wall, const Domain& domain) const {
  const Vec3 middle = (domain.lower + domain.upper) / 2;
  return wall.point + (middle - wall.point).dot(wall.axis) * wall.axis;
}

Single::CylinderShape Coordinates<Single>::cylinder(const Cylinder& wall, const Domain& domain) const {
  const auto [one, two] = across(wall.axis);
  const Vec3 at = held_at(wall, domain);
  return {{plane_held_at(at, one), plane_held_at(at, two)}, reach(wall.radius)};
}

Single::PlaneShape Coordinates<Single>::plane(const Plane& wall, const Domain& domain) const {
  return plane_held_at(held_at(wall, domain), wall.normal);
}

Single::PlaneShape Coordinates<Single>::plane_held_at(const Vec3& point, const Vec3& normal) const {
  const Single::Position p = position(point);
  Single::PlaneShape shape{};
  shape.whole = p.whole;
  shape.part = p.part;
  for (int axis = 0; axis < 3; ++axis) {
    const double whole = std::nearbyint(std::ldexp(normal[axis], 30));
    shape.normal_whole.s[axis] = static_cast<cl_long>(whole);
    shape.normal_part.s[axis] = static_cast<cl_float>(normal[axis] - std::ldexp(whole, -30));
    shape.normal.s[axis] = static_cast<cl_float>(normal[axis]);
  }
  return shape;
}

Single::RectangleShape Coordinates<Single>::rectangle(const Rectangle& wall) const {
  const Vec3 half = (wall.upper - wall.lower) / 2;
  Single::RectangleShape shape{};
  shape.centre = position(wall.lower + half);
  for (int axis = 0; axis < 3; ++axis) {
    const Split s = split(half[axis] / quantum_);
    shape.half_whole.s[axis] = s.whole;
    shape.half_part.s[axis] = s.part;
  }
  return shape;
}

Single::Wave Coordinates<Single>::wave(double wave_number) const {
  constexpr long double turn = 2 * std::numbers::pi_v<long double>;
  Single::Wave wave{};
  for (int axis = 0; axis < 3; ++axis) {
    wave.offset.s[axis] = turn_bits(wave_number * static_cast<long double>(lower_[axis]) / turn);
    wave.turns.s[axis] = turn_bits(wave_number * static_cast<long double>(quantum_) / turn);
    wave.radians.s[axis] = static_cast<cl_float>(wave_number * quantum_);
  }
  return wave;
}

}  // namespace grainproof::opencl
