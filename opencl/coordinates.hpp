// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
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
  Single::PlaneShape plane(const Plane& wall, const Domain& domain) const;
  Single::RectangleShape rectangle(const Rectangle& wall) const;
  Single::Wave wave(double wave_number) const;

 private:
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
  Double::PlaneShape plane(const Plane& wall, const Domain& domain) const;
  Double::RectangleShape rectangle(const Rectangle& wall) const;
  Double::Wave wave(double wave_number) const;

 private:
  Vec3 origin_;
};

}  // namespace grainproof::opencl
