// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "model/scene.hpp"

/// The equations of motion of docs/laws/ for at most one contact, written a second time and integrated
/// with 34 digits by an eighth-order method that stops at every change of regime. Coulomb friction must
/// not bring a slip to rest.
namespace grainproof::analytic::exact {

using Real = boost::multiprecision::cpp_bin_float_quad;
using Vector = std::array<Real, 3>;
using State = std::array<Real, 12>;  ///< x1, x2, v1, v2

/// Which branch of every law acts: two states of equal regime have a smooth force between them.
struct Regime {
  bool bodies = false;    ///< δ_b > 0
  bool effects = false;   ///< δ_e > 0
  bool pulling = false;   ///< k δ_b − η u_n < 0
  bool creeping = false;  ///< the static branch of friction is the smaller one
  bool operator==(const Regime&) const = default;
};

class World {
 public:
  explicit World(const Scene& scene);

  State start() const;
  Regime regime(const State& state) const;
  /// Accelerations of both bodies in the branches of `regime`.
  std::array<Vector, 2> accelerations(const State& state, const Regime& regime) const;
  /// States at `times`, increasing, with steps of at most `step`.
  std::vector<State> integrate(const std::vector<double>& times, double step) const;

 private:
  struct Contact {
    Vector normal;
    Real body_overlap, effect_overlap, normal_velocity, slip_speed;
    Vector slip;
  };
  Real set_geometry();
  void set_laws(const ContactLaws& laws, const Real& m);
  Contact contact(const State& state) const;
  Real elastic_and_damping(const Contact& c) const;
  Vector force_on_second(const State& state, const Regime& regime) const;
  State advanced(const State& state, const Regime& regime, const Real& step) const;
  void go(State& state, Regime& regime, const Real& span) const;

  Scene scene_;
  bool meets_ = false;
  bool wall_ = false;
  std::array<Real, 2> mass_{1, 1};
  Real touching_ = 0, effect_ = 0, stiffness_ = 0, damping_ = 0, cohesion_ = 0, coefficient_ = 0,
       viscosity_ = -1;
  bool no_tension_ = false;
  Vector gravity_{}, stream_{}, wall_normal_{}, wall_point_{};
  std::array<Real, 2> drag_rate_{0, 0};
};

}  // namespace grainproof::analytic::exact
