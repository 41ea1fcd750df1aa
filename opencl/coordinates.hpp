// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "model/scene.hpp"
#include "opencl/layout.hpp"

namespace grainproof::opencl {

/// From metres to what a device holds, and back. docs/precision.md
template <class P>
class Coordinates;

template <>
class Coordinates<Single> {
 public:
  explicit Coordinates(const Domain& domain);

  Single::Position position(const Vec3& at, double radius = 0.0) const;
  Single::Reach reach(double length) const;
  Vec3 metres(const Single::Position& p) const;
  /// Position units per metre: what turns a velocity times a time into a displacement.
  double per_metre() const { return 1.0 / quantum_; }

  Single::Box box(const Domain& domain, const std::array<int, 3>& zones, double skin) const;
  /// Where a wall's shape is held: a point of the plane or of the axis, near the domain where that matters.
  Vec3 held_at(const Plane& wall, const Domain& domain) const;
  Vec3 held_at(const Cylinder& wall, const Domain& domain) const;
  Single::PlaneShape plane(const Plane& wall, const Domain& domain) const;
  Single::CylinderShape cylinder(const Cylinder& wall, const Domain& domain) const;
  Single::RectangleShape rectangle(const Rectangle& wall) const;
  Single::Wave wave(double wave_number) const;

 private:
  Single::PlaneShape plane_held_at(const Vec3& point, const Vec3& normal) const;

  Vec3 lower_;
  double quantum_;
};

template <>
class Coordinates<Double> {
 public:
  explicit Coordinates(const Domain& domain);

  Double::Position position(const Vec3& at, double radius = 0.0) const;
  Double::Reach reach(double length) const { return length; }
  Vec3 metres(const Double::Position& p) const;
  double per_metre() const { return 1.0; }

  Double::Box box(const Domain& domain, const std::array<int, 3>& zones, double skin) const;
  /// Where a wall's shape is held: a point of the plane or of the axis, near the domain where that matters.
  Vec3 held_at(const Plane& wall, const Domain& domain) const;
  Vec3 held_at(const Cylinder& wall, const Domain& domain) const;
  Double::PlaneShape plane(const Plane& wall, const Domain& domain) const;
  Double::CylinderShape cylinder(const Cylinder& wall, const Domain& domain) const;
  Double::RectangleShape rectangle(const Rectangle& wall) const;
  Double::Wave wave(double wave_number) const;

 private:
  Vec3 origin_;
};

template <>
class Coordinates<Mixed> : public Coordinates<Double> {
 public:
  using Coordinates<Double>::Coordinates;
};

/// Two unit vectors, perpendicular to each other and to `axis`; exact along the axes of the scene.
std::array<Vec3, 2> across(const Vec3& axis);

}  // namespace grainproof::opencl
