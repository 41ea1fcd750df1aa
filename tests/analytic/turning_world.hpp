// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>

#include "tests/analytic/scenes.hpp"

/// A sphere that turns against a wall, with 34 digits.
namespace grainproof::analytic::turning {

using Real = boost::multiprecision::cpp_bin_float_quad;
using Vector = Eigen::Matrix<Real, 3, 1>;

inline const Vec3 slanted = Vec3(2.0, -3.0, 6.0) / 7.0;
inline const Vec3 aside = Vec3(6.0, -2.0, -3.0) / 7.0;  // at right angles to `slanted`
inline constexpr double mu = 0.3;

/// A sphere of diameter 0.1 and density 2000 on a wall through the origin, 3 m/s along it.
inline Scene on_wall(const ContactLaws& laws, double gap, double inward, const Vec3& spin) {
  Scene scene = glass_scene();
  scene.rotation = true;
  scene.contacts.set(0, 0, laws);
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), slanted}});
  add_sphere(scene, (0.05 + gap) * slanted, 3.0 * aside - inward * slanted);
  scene.particles[0].angular_velocity = spin;
  return scene;
}

/// The wall contact of docs/laws/rotation.md, written a second time, with 34 digits. The spring is kept
/// at its limit while `sliding`.
struct Sphere {
  Vector x, v, w, spring;
};

struct World {
  Real mass = Real(2000) * boost::math::constants::pi<Real>() / 6 / 1000, radius = Real(0.1) / 2;
  Vector normal = slanted.cast<Real>().normalized();
  Real gravity = 0, stiffness = 0, dashpot = 0;  ///< Hertz: K, and η/δ^(1/4)
  bool hertz = false;
  Real spring = 0;  ///< 0: none
  bool sliding = true, pulling = false;
  Vector along = Vector::Zero();  ///< where the slip is to come to an end, its direction

  Real overlap(const Sphere& s) const { return radius - s.x.dot(normal); }
  Vector slip(const Sphere& s) const {
    const Vector u = s.v - radius * s.w.cross(normal);
    return u - u.dot(normal) * normal;
  }
  Real push(const Sphere& s) const {
    const Real d = overlap(s);
    if (!(d > 0)) return 0;
    const Real root = hertz ? sqrt(d) : Real(1);
    return stiffness * d * root - dashpot * (hertz ? Real(sqrt(root)) : Real(1)) * s.v.dot(normal);
  }
  Vector friction(const Sphere& s) const {
    if (!sliding) return -spring * s.spring;
    const Vector u = along.isZero() ? slip(s) : along;
    return Real(mu) * (pulling ? push(s) : Real(-push(s))) / u.norm() * u;
  }
  Sphere rate(const Sphere& s) const {
    const Vector f = friction(s);
    return {s.v, (push(s) / mass - gravity) * normal + f / mass,
            Vector((-radius * normal).cross(f) * (5 / (2 * mass * radius * radius))), slip(s)};
  }
  Sphere stepped(const Sphere& s, const Real& h) const {
    const auto plus = [&](const Real& part, const Sphere& k) {
      return Sphere{s.x + part * k.x, s.v + part * k.v, s.w + part * k.w, s.spring + part * k.spring};
    };
    const auto mean = [&](const Vector Sphere::*of, const Sphere& a, const Sphere& b, const Sphere& c,
                          const Sphere& d) {
      return Vector(s.*of + h / 6 * (a.*of + 2 * b.*of + 2 * c.*of + d.*of));
    };
    const Sphere a = rate(s), b = rate(plus(h / 2, a)), c = rate(plus(h / 2, b)), d = rate(plus(h, c));
    return {mean(&Sphere::x, a, b, c, d), mean(&Sphere::v, a, b, c, d), mean(&Sphere::w, a, b, c, d),
            mean(&Sphere::spring, a, b, c, d)};
  }
};

inline Sphere start_of(const Scene& scene) {
  const Particle& p = scene.particles[0];
  return {p.position.cast<Real>(), p.velocity.cast<Real>(), p.angular_velocity.cast<Real>(), Vector::Zero()};
}

/// The least time, up to `high`, from which on `holds` is true, as it is at `high`.
template <class Holds>
Real halved(Real high, const Holds& holds) {
  Real low = 0;
  for (int halving = 0; halving < 100; ++halving) {
    const Real middle = (low + high) / 2;
    (holds(middle) ? high : low) = middle;
  }
  return high;
}

inline void expect_near(const Frame& frame, const Sphere& exact, double length, double speed) {
  EXPECT_LE((frame.position[0].cast<Real>() - exact.x).norm(), length) << frame.time;
  EXPECT_LE((frame.velocity[0].cast<Real>() - exact.v).norm(), speed) << frame.time;
  EXPECT_LE((frame.angular_velocity[0].cast<Real>() - exact.w).norm(), 20 * speed) << frame.time;
}

}  // namespace grainproof::analytic::turning
