// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/schemes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic/spectral_limit.hpp"
#include "model/errors.hpp"

namespace grainproof::analytic {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Two coupled bodies of mass 1 stepped as docs/laws/integrators.md says, springs by history.1.
struct Stepped {
  Matrix2d K, H, C, D;
  double h;
  Vector2d x{1.0, -0.4}, v{0.3, 0.2}, s{1.0, -0.4}, a{0.0, 0.0}, half{0.0, 0.0}, a_before{0.0, 0.0};

  Vector2d force(const Vector2d& velocity, double elapsed) {
    s += elapsed * velocity;
    return -K * x - H * s - C * velocity;
  }

  void trapezoid(bool implicit, bool first) {
    const Vector2d before = v;
    if (first) a = force(v, 0.0);
    v = implicit ? Vector2d((Matrix2d::Identity() + h * D).inverse() * (v + h * a))
                 : Vector2d(v + h * (a - D * v));
    x += 0.5 * h * (before + v);
    a = force(v, h);
  }

  void leapfrog(bool first) {
    a = force(first ? v : half, first ? 0.0 : h) - D * (first ? v : half);
    half = first ? Vector2d(v + 0.5 * h * a) : Vector2d(half + h * a);
    x += h * half;
  }

  void verlet(bool predicted, bool first) {
    if (first) a = force(v, 0.0) - D * v;
    a_before = a;
    half = v + 0.5 * h * a;
    x += h * half;
    const Vector2d seen = predicted ? Vector2d(half + 0.5 * h * a) : half;
    s += h * half;
    a = force(seen, 0.0) - D * seen;
    v = half + 0.5 * h * a;
  }

  void step(std::string_view scheme, bool first) {
    if (scheme == "euler_trapezoid") return trapezoid(false, first);
    if (scheme == "euler_trapezoid_implicit_drag") return trapezoid(true, first);
    if (scheme == "leapfrog_verlet") return leapfrog(first);
    verlet(scheme != "velocity_verlet", first);
  }

  /// What the scheme's matrix acts on.
  VectorXd state(std::string_view scheme) const {
    VectorXd all(8);
    if (scheme.starts_with("euler")) return (all << x, h * v, s, 0.0, 0.0).finished().head(6);
    if (scheme == "velocity_verlet" || scheme == "leapfrog_verlet")
      return (all << x, h * half, 0.0, 0.0, 0.0, 0.0).finished().head(4);
    return (all << x, h * half, h * h * a_before, 0.0, 0.0).finished().head(6);
  }
};

class LinearSchemes : public testing::TestWithParam<LinearScheme> {};

TEST_P(LinearSchemes, TakeTheStateWhereTheRecurrenceTakesIt) {
  const LinearScheme& scheme = GetParam();
  Stepped stepped{.K = Matrix2d{{90.0, -40.0}, {-40.0, 60.0}},
                  .H = Matrix2d{{20.0, 5.0}, {5.0, 30.0}},
                  .C = Matrix2d{{3.0, -1.0}, {-1.0, 2.0}},
                  .D = Matrix2d{{0.7, 0.0}, {0.0, 1.9}},
                  .h = 0.05};
  const Eigen::MatrixXd matrix = scheme.step({stepped.K, stepped.H, stepped.C, stepped.D}, stepped.h);
  for (int n = 0; n < 3; ++n) stepped.step(scheme.name, n == 0);
  for (int n = 0; n < 20; ++n) {
    const VectorXd before = stepped.state(scheme.name);
    stepped.step(scheme.name, false);
    EXPECT_LT((matrix * before - stepped.state(scheme.name)).norm(), 1e-14 * before.norm()) << n;
  }
}

LinearSystem one_body(const LinearContact& contact) {
  const auto number = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
  return {number(contact.stiffness / contact.mass), number(contact.remembered / contact.mass),
          number(contact.damping / contact.mass), number(contact.drag_rate)};
}

TEST_P(LinearSchemes, HaveInClosedFormTheLimitOfTheirMatrix) {
  for (const LinearContact& contact :
       {LinearContact{1.047, 1e5, 0.0, 45.8, 0.0}, LinearContact{1.047, 1e5, 0.0, 900.0, 0.0},
        LinearContact{1.047, 1e5, 0.0, 0.0, 0.0}, LinearContact{0.5, 2e4, 0.0, 20.0, 30.0},
        LinearContact{0.5, 2e4, 0.0, 300.0, 100.0}, LinearContact{0.5, 0.0, 2e4, 0.0, 0.0},
        LinearContact{0.5, 0.0, 2e4, 25.0, 0.0}, LinearContact{0.5, 0.0, 2e4, 300.0, 0.0}}) {
    const double closed = pair_limit(GetParam(), contact);
    const double spectral = spectral_limit(GetParam(), {one_body(contact)});
    EXPECT_NEAR(spectral, closed, 2e-5 * closed) << contact.stiffness << " " << contact.damping;
  }
}

/// The spring that remembers alone, by the recurrence itself.
double swing_after(std::string_view scheme, double h, int steps) {
  Stepped stepped{.K = Matrix2d::Zero(),
                  .H = 100.0 * Matrix2d::Identity(),
                  .C = Matrix2d::Zero(),
                  .D = Matrix2d::Zero(),
                  .h = h};
  double largest = 0.0;
  for (int n = 0; n < steps; ++n) {
    stepped.step(scheme, n == 0);
    if (n >= steps - 100) largest = std::max(largest, stepped.x.norm());
  }
  return largest;
}

TEST(LinearScheme, WithPredictedVelocitiesKeepsTheSwingOfASpringThatRemembers) {
  const auto& scheme = linear_scheme("velocity_verlet_predicted");
  const LinearContact bare{0.5, 0.0, 2e4, 0.0, 0.0};
  EXPECT_NEAR(growth_a_step(scheme, {one_body(bare)}, 0.1 / std::sqrt(2e4 / 0.5)), 1.0, 1e-14);
  // Within what the phase of the sampled maximum leaves open, and the rounding of a hundred thousand steps.
  EXPECT_NEAR(swing_after("velocity_verlet_predicted", 0.03, 100000),
              swing_after("velocity_verlet_predicted", 0.03, 200), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(, LinearSchemes, testing::ValuesIn(linear_schemes()),
                         [](const auto& param) { return std::string(param.param.name); });

TEST(LinearScheme, IsKnownOfEveryIntegrator) {
  for (const auto& [name, integrator] : integrator_names) EXPECT_EQ(linear_scheme(integrator).name, name);
  EXPECT_THROW(linear_scheme("runge_kutta"), InputRefused);
}

/// The recurrence itself, so that the closed form is not held against its own matrix alone.
double growth_of_predicted(double k, double c, double h) {
  Stepped stepped{.K = k * Matrix2d::Identity(),
                  .H = Matrix2d::Zero(),
                  .C = c * Matrix2d::Identity(),
                  .D = Matrix2d::Zero(),
                  .h = h};
  for (int n = 0; n < 2000; ++n) stepped.step("velocity_verlet_predicted", n == 0);
  return stepped.x.norm();
}

TEST(LinearScheme, WithPredictedVelocitiesDecaysBelowItsLimitAndGrowsAbove) {
  const auto& scheme = linear_scheme("velocity_verlet_predicted");
  for (const double c : {3.0, 20.0, 80.0}) {  // of a critical 20
    const double limit = pair_limit(scheme, {1.0, 100.0, 0.0, c, 0.0});
    EXPECT_NEAR(100.0 * limit * limit + 4.0 * c * limit, 4.0, 1e-13);
    EXPECT_LT(growth_of_predicted(100.0, c, 0.99 * limit), 1e-3) << c;
    EXPECT_GT(growth_of_predicted(100.0, c, 1.01 * limit), 1e3) << c;
  }
}

}  // namespace
}  // namespace grainproof::analytic
