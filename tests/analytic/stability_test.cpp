// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/contact_scales.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

/// One particle on a spring, dashpot and still fluid, stepped as the scheme says.
/// Returns the largest |x| of the last tenth of the run over that of the first tenth.
double growth(Integrator scheme, double m, double k, double eta, double drag, double h) {
  double x = 1.0, v = 0.3, first = 0.0, last = 0.0;
  const int steps = 4000;
  for (int n = 0; n < steps; ++n) {
    const double contact = -(k * x + eta * v) / m;
    const double before = v;
    switch (scheme) {
      case Integrator::euler_trapezoid:
        v += h * (contact - drag * v);
        x += 0.5 * h * (before + v);
        break;
      case Integrator::euler_trapezoid_implicit_drag:
        v = (v + h * contact) / (1.0 + h * drag);
        x += 0.5 * h * (before + v);
        break;
      default:
        v += h * (contact - drag * v);
        x += h * v;
    }
    const double size = std::hypot(x, v * std::sqrt(m / k));
    if (n < steps / 10) first = std::max(first, size);
    if (n >= steps - steps / 10) last = std::max(last, size);
    if (!(size < 1e100)) return std::numeric_limits<double>::infinity();
  }
  return last / first;
}

struct Contact {
  double m, k, eta, drag;
};

class EveryScheme : public testing::TestWithParam<Integrator> {};

TEST_P(EveryScheme, DecaysJustBelowItsLimitAndGrowsJustAbove) {
  for (const Contact& c : {Contact{1.047, 1e5, 45.8, 0.0}, Contact{1.047, 1e5, 900.0, 0.0},
                           Contact{0.5, 2e4, 20.0, 30.0}, Contact{0.5, 2e4, 300.0, 100.0}}) {
    const double limit = pair_stability_limit(GetParam(), c.m, c.k, c.eta, c.drag);
    ASSERT_TRUE(std::isfinite(limit));
    EXPECT_LT(growth(GetParam(), c.m, c.k, c.eta, c.drag, 0.99 * limit), 0.5) << limit;
    EXPECT_GT(growth(GetParam(), c.m, c.k, c.eta, c.drag, 1.01 * limit), 2.0) << limit;
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryScheme,
                         testing::Values(Integrator::euler_trapezoid,
                                         Integrator::euler_trapezoid_implicit_drag,
                                         Integrator::leapfrog_verlet, Integrator::velocity_verlet),
                         [](const auto& param) { return std::string(name_of(param.param)); });

TEST(StabilityLimit, OfTheSettlingCaseIsTwiceDampingOverStiffness) {  // E15
  Scene scene = glass_scene();
  scene.run.integrator = Integrator::euler_trapezoid;
  add_sphere(scene, {0, 0, 0.05}, {0, 0, 0});
  add_floor(scene);
  EXPECT_NEAR(stability_limit(scene).step, 0.000917, 5e-7);
  EXPECT_NE(stability_limit(scene).because.find("wall floor"), std::string::npos);
}

TEST(StabilityLimit, OfTheSourceSchemeWithoutDampingIsZero) {  // E15
  EXPECT_EQ(pair_stability_limit(Integrator::euler_trapezoid, 1.0, 1e5, 0.0), 0.0);
  EXPECT_GT(growth(Integrator::euler_trapezoid, 1.0, 1e5, 0.0, 0.0, 1e-4), 2.0);
}

TEST(StabilityLimit, OfVerletWithoutDampingIsTwoOverTheFrequency) {
  EXPECT_NEAR(pair_stability_limit(Integrator::velocity_verlet, 1.0, 1e4, 0.0), 0.02, 1e-16);
}

TEST(StabilityLimit, OfDragIsTwiceTheRelaxationTimeUnlessImplicit) {
  Scene scene = glass_scene();
  add_sphere(scene, {0, 0, 0}, {0, 0, 0});
  scene.materials[0].density = 10.0;
  scene.flow = UniformFlow{1.93e-3, Vec3::UnitX()};
  const double relaxation = 10.0 * 0.01 / (18.0 * 1.93e-3);
  for (Integrator scheme : {Integrator::euler_trapezoid, Integrator::velocity_verlet}) {
    scene.run.integrator = scheme;
    EXPECT_NEAR(stability_limit(scene).step / (2.0 * relaxation), 1.0, 1e-14);
  }
  scene.run.integrator = Integrator::euler_trapezoid_implicit_drag;
  EXPECT_TRUE(std::isinf(stability_limit(scene).step));
}

/// The tangential spring and the spring against rolling of a sphere on a wall (rolling.9), step by step:
/// displacement and turn as paths, slip and surface speed as rates.
double growth_of_roll(double rate, double h) {
  double slip = 0.3, surface = -0.2, spring = 0.0, turn = 0.0, largest = 0.0;
  for (int n = 0; n < 4000; ++n) {
    spring += h * slip;
    turn += h * surface;
    slip -= h * rate * (3.5 * spring - 2.5 * turn);
    surface += h * rate * (2.5 * spring - 2.5 * turn);
    largest = std::max(largest, std::abs(slip));
    if (!(largest < 1e100)) break;
  }
  return largest;
}

TEST(StabilityLimit, OfASpringAgainstRollingIsThatOfBothSpringsTogether) {
  Scene scene = glass_scene({1e3, Restitution{1.0}});  // soft, so that friction is what limits
  scene.rotation = true;
  const double k_t = 1e6, rate = k_t / sphere_mass(2000.0, 0.1);
  add_sphere(scene, {0, 0, 0.05}, {0, 0, -1});
  add_floor(scene);
  const auto limit_with = [&](const RollingLaw& rolling) {
    scene.contacts.set(0, 0,
                       ContactLaws{LinearNormal{1e3, Restitution{1.0}}, HistoryFriction{0.3, k_t, 0.0},
                                   NoCohesion{}, rolling});
    return stability_limit(scene).step;
  };
  const double limit = limit_with(SpringRolling{0.1});
  EXPECT_LT(growth_of_roll(rate, 0.999 * limit), 100.0);
  EXPECT_GT(growth_of_roll(rate, 1.001 * limit), 1e50);
  EXPECT_NEAR(limit_with(ConstantTorqueRolling{0.1}) / limit_with(NoRolling{}), 1.0, 1e-15);
  EXPECT_NEAR(limit_with(NoRolling{}), 2.0 / std::sqrt(3.5 * rate), 1e-12);
}

TEST(CreepLimit, IsTwoMassesOverStiffnessTimesCollisionTime) {
  const double m = 1.047, k = 2e5, k_f = 1e5, t_c = M_PI * std::sqrt(m / k);
  const LinearNormal normal{k, Restitution{0.8}};
  const auto scheme = Integrator::velocity_verlet;
  EXPECT_NEAR(creep_limit(scheme, m, normal, CollisionTimeFriction{0.6, k_f}), 2.0 * m / (k_f * t_c), 1e-16);
  EXPECT_NEAR(creep_limit(scheme, m, normal, DampedFriction{0.6, k_f}),
              2.0 * m / (k_f * t_c + damping(normal, m)), 1e-16);
  EXPECT_NEAR(creep_limit(scheme, m, normal, StepFriction{0.6, k_f}), std::sqrt(2.0 * m / k_f), 1e-16);
  EXPECT_TRUE(std::isinf(creep_limit(scheme, m, normal, DynamicFriction{0.6})));
}

TEST(CreepLimit, IsShorterWhereTheDashpotTakesTheVelocityPredictedForTheBoundary) {
  const double m = 1.047, k = 2e5, k_f = 1e5, t_c = M_PI * std::sqrt(m / k);
  const LinearNormal normal{k, Restitution{0.8}};
  for (const auto scheme : {Integrator::velocity_verlet_predicted, Integrator::onset_corrected}) {
    EXPECT_NEAR(creep_limit(scheme, m, normal, CollisionTimeFriction{0.6, k_f}), m / (k_f * t_c), 1e-16);
    EXPECT_NEAR(creep_limit(scheme, m, normal, StepFriction{0.6, k_f}), std::sqrt(m / k_f), 1e-16);
  }
}

}  // namespace
}  // namespace grainproof::analytic
