// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "analytic/dimensionless.hpp"
#include "analytic/linear_motion.hpp"
#include "tests/analytic/scenes.hpp"

/// Each test holds the corrected form to a number or an equation and shows that the printed one of
/// docs/errata.md misses it.
namespace grainproof::analytic {
namespace {

/// The example of E5: m 1.047, k_e 1e5, k_c 1e3, d_b 0.1, d_e 0.12, restitution 0.8.
struct CohesiveExample {
  double m = 1.047, k_e = 1e5, k_c = 1e3, reach = 0.02, e = 0.8, u0 = 1.0;
  double eta = damping({k_e, Restitution{e}}, m);
  double impact_speed() const { return std::hypot(u0, reach * std::sqrt(k_c / m)); }

  Scene scene() const {
    Scene scene = glass_scene({k_e, Restitution{e}});
    scene.materials[0].density = m * 6.0 / (std::numbers::pi * 1e-3);
    scene.contacts.set(0, 0, {LinearNormal{k_e, Restitution{e}}, Frictionless{}, LinearCohesion{k_c}});
    add_sphere(scene, Vec3::Zero(), Vec3::Zero(), true);
    add_sphere(scene, Vec3(0.12, 0, 0), Vec3(-u0, 0, 0));
    for (Particle& particle : scene.particles) particle.effect_diameter = 0.12;
    return scene;
  }

  std::map<std::string, double> scalars() const {
    return make_closed_form("cohesive_collision")->observe(scene(), {}).scalars;
  }
};

TEST(E1, AContactReboundsBelowCriticalDampingAndOnlyThere) {
  const double m = 1.047, k = 1e5, critical = 2.0 * std::sqrt(m * k);
  EXPECT_GT(restitution_of(0.9 * critical, k, m), 0.0);
  EXPECT_EQ(restitution_of(1.1 * critical, k, m), 0.0);
  // Where the text claims complex roots, its own frequency is not a number.
  EXPECT_TRUE(std::isnan(std::sqrt(4.0 * m * k - std::pow(1.1 * critical, 2))));
}

TEST(E2, OnlyTheStiffnessDifferenceSatisfiesTheEquationOfMotion) {
  const CohesiveExample c;
  const double a = -c.eta / (2.0 * c.m);
  const auto residual = [&](double b) {
    // x = e^{at} sin bt in m x'' + η x' + (k_e − k_c) x = 0, divided by its largest term.
    const double t = 1e-3, s = std::sin(b * t), co = std::cos(b * t);
    const double force =
        c.m * ((a * a - b * b) * s + 2.0 * a * b * co) + c.eta * (a * s + b * co) + (c.k_e - c.k_c) * s;
    return std::abs(force) / (c.k_e * s);
  };
  EXPECT_LT(residual(std::sqrt(4.0 * c.m * (c.k_e - c.k_c) - c.eta * c.eta) / (2.0 * c.m)), 1e-14);
  EXPECT_GT(residual(std::sqrt(4.0 * c.m * c.k_e - c.eta * c.eta) / (2.0 * c.m)), 5e-3);
}

TEST(E3, AttractionQuickensTheApproachByTheHyperbolicCosine) {
  const CohesiveExample c;
  const double omega = std::sqrt(c.k_c / c.m);
  const double impact_time = std::asinh(c.reach * omega / c.u0) / omega;
  const LinearMotion attracted({c.m, -c.k_c, 0.0, -c.k_c * c.reach}, {c.reach, -c.u0});
  const double seen = -attracted.at(impact_time).velocity;
  EXPECT_NEAR(seen, c.u0 * std::cosh(omega * impact_time), 1e-14);
  EXPECT_NEAR(seen, c.impact_speed(), 1e-14);  // energy
  const double printed = 0.5 * c.u0 * (std::exp(omega * impact_time) - std::exp(-omega * impact_time));
  EXPECT_GT(std::abs(printed - seen), 0.4 * seen);
  EXPECT_NEAR(c.scalars().at("contact_onset_time"), impact_time, 1e-15);
}

TEST(E5, TheReturnIsTheRootOfTheGap) {
  const CohesiveExample c;
  const auto scalars = c.scalars();
  // Root and slope of x(t) = d_b by mpmath with 40 digits.
  EXPECT_NEAR(scalars.at("contact_duration"), 1.06324822647e-2, 1e-13);
  EXPECT_NEAR(scalars.at("return_speed"), 0.922736236861, 1e-12);
  const double printed_b = std::sqrt(4.0 * c.m * c.k_e - c.eta * c.eta) / (2.0 * c.m);
  EXPECT_NEAR(std::numbers::pi / printed_b, 1.0190980878e-2, 1e-12);  // the printed estimate, 4 % short
  EXPECT_NEAR(c.e * c.impact_speed(), 0.940482917672, 1e-12);         // 2 % fast
}

TEST(E6, TheStickingSpeedIsNotWhereStickinessIsOne) {
  CohesiveExample c;
  const auto scalars = c.scalars();
  const double exact = scalars.at("sticking_speed"), source = scalars.at("sticking_speed_source");
  EXPECT_NEAR(exact, 0.4998, 5e-5);
  EXPECT_NEAR(source, 0.4636, 5e-5);
  EXPECT_NEAR(stickiness_number(c.reach, c.k_c, c.e, source, c.m), 1.0, 1e-14);
  c.u0 = exact * (1.0 - 1e-9);
  EXPECT_EQ(c.scalars().at("sticks"), 1.0);
  c.u0 = exact * (1.0 + 1e-9);
  EXPECT_EQ(c.scalars().at("sticks"), 0.0);
  c.u0 = 0.5 * (source + exact);  // the source's number lets this one go
  EXPECT_EQ(c.scalars().at("sticks"), 1.0);
  EXPECT_LT(c.scalars().at("stickiness"), 1.0);
}

TEST(E7, CohesionPullsTogether) {
  CohesiveExample c;
  const Scene scene = c.scene();
  Request request;
  request.times = {0.0, 0.01};
  const auto frames = make_closed_form("cohesive_collision")->observe(scene, request).frames;
  EXPECT_LT(frames[1].velocity[1].x(), frames[0].velocity[1].x());
}

TEST(E9, AStoppedSphereRests) {
  Scene scene = glass_scene();
  scene.contacts.set(0, 0, {LinearNormal{1e5, Restitution{0.8}}, DynamicFriction{0.6}});
  scene.gravity = ConstantGravity{{0, 0, -9.81}};
  add_floor(scene);
  add_sphere(scene, {0, 0, 0.05 - sphere_mass(2000.0, 0.1) * 9.81 / 1e5}, {1.0, 0, 0});
  Request request;
  const double stop = 1.0 / (0.6 * 9.81);
  request.times = {0.5 * stop, stop * 1.01, 3.0 * stop};
  const Observations seen = make_closed_form("sliding")->observe(scene, request);
  EXPECT_NEAR(seen.scalars.at("stop_time"), stop, 1e-15);
  EXPECT_NEAR(seen.scalars.at("stop_distance"), 0.5 * stop, 1e-15);
  EXPECT_NEAR(seen.frames[0].velocity[0].x(), 0.5, 1e-15);
  for (int n : {1, 2}) {
    EXPECT_EQ(seen.frames[n].velocity[0].x(), 0.0);
    EXPECT_NEAR(seen.frames[n].position[0].x(), 0.5 * stop, 1e-15);
    EXPECT_LT(1.0 - 0.6 * 9.81 * request.times[n], -0.005);  // the printed velocity has turned round
  }
}

TEST(E10, MeanTaylorGreenSpeedIsLessThanPrinted) {
  EXPECT_NEAR(taylor_green_mean_speed(), 0.77994, 5e-6);
  EXPECT_GT(std::abs(0.7839 - taylor_green_mean_speed()), 3e-3);
}

}  // namespace
}  // namespace grainproof::analytic
