// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "analytic/dimensionless.hpp"
#include "tests/analytic/exact_integration.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

const double m = sphere_mass(2000.0, 0.1);
constexpr double k = 1e5;

std::map<std::string, double> scalars_of(const char* form, const Scene& scene) {
  return make_closed_form(form)->observe(scene, {}).scalars;
}

Scene onto_fixed(const LinearNormal& law, double gap = 0.0) {
  Scene scene = glass_scene(law);
  add_sphere(scene, Vec3::Zero(), Vec3::Zero(), true);
  add_sphere(scene, {0.1 + gap, 0, 0}, {-2.0, 0, 0});
  return scene;
}

TEST(NormalCollision, LastsHalfADampedPeriodAndReboundsAtItsRestitution) {
  for (double e : {0.2, 0.5, 0.8, 1.0}) {
    const LinearNormal law{k, Restitution{e}};
    const auto s = scalars_of("normal_collision", onto_fixed(law));
    const double eta = damping(law, m), beta = eta / (2 * m), omega = std::sqrt(k / m - beta * beta);
    EXPECT_NEAR(s.at("contact_duration"), std::numbers::pi / omega, 1e-16) << e;
    EXPECT_NEAR(s.at("restitution"), e, 1e-14) << e;
    const double peak = 2.0 * std::sqrt(m / k) * std::exp(-beta / omega * std::atan2(omega, beta));
    EXPECT_NEAR(s.at("peak_overlap"), peak, 1e-16) << e;
    EXPECT_EQ(s.at("contact_onset_time"), 0.0);
  }
}

TEST(NormalCollision, BeginsWhenTheGapIsCrossed) {
  const auto s = scalars_of("normal_collision", onto_fixed({k, Restitution{0.8}}, 1e-4));
  EXPECT_NEAR(s.at("contact_onset_time"), 5e-5, 1e-16);  // a rounding of 0.1 m at 2 m/s
}

TEST(NormalCollision, WithoutTensionEndsAtForceZeroAndLeavesAtItsRestitution) {
  for (double e : {0.1, std::exp(-2.0), 0.5, 0.8}) {
    const auto s = scalars_of("normal_collision", onto_fixed({k, Restitution{e}, true}));
    EXPECT_NEAR(s.at("restitution"), e, 1e-13) << e;
    const double beta = damping({k, Restitution{e}, true}, m) / (2 * m);
    EXPECT_NEAR(s.at("force_duration"), -std::log(e) / beta, 1e-15) << e;
    EXPECT_GT(s.at("contact_duration"), s.at("force_duration"));
  }
}

TEST(NormalCollision, CriticalAndOverDampedContactsNeverEnd) {
  const double critical = 2.0 * std::sqrt(m * k);
  for (double eta : {critical, 2.0 * critical}) {
    const auto s = scalars_of("normal_collision", onto_fixed({k, Damping{eta}}));
    EXPECT_EQ(s.at("restitution"), 0.0);
    EXPECT_FALSE(s.contains("contact_duration"));
  }
  const auto s = scalars_of("normal_collision", onto_fixed({k, Damping{critical}}));
  EXPECT_NEAR(s.at("peak_overlap"), 2.0 * std::sqrt(m / k) / std::numbers::e, 1e-16);
}

TEST(NormalCollision, OfTwoFreeSpheresKeepsMomentum) {
  Scene scene = glass_scene();
  add_sphere(scene, {0, 0, 0}, {0.5, 0, 0}, false, 0.1);
  add_sphere(scene, {0.08, 0, 0}, {-1.5, 0, 0}, false, 0.06);
  const Observations seen = make_closed_form("normal_collision")->observe(scene, {});
  const double m2 = sphere_mass(2000.0, 0.06);
  const auto momentum = [&](const Frame& f) { return m * f.velocity[0].x() + m2 * f.velocity[1].x(); };
  EXPECT_NEAR(momentum(seen.frames.back()), momentum(seen.frames.front()), 1e-15);
  const auto closing = [](const Frame& f) { return f.velocity[0].x() - f.velocity[1].x(); };
  EXPECT_NEAR(closing(seen.frames.back()), -0.8 * 2.0, 1e-14);
}

TEST(Settling, EndsAtWeightOverStiffness) {
  Scene scene = glass_scene();
  scene.gravity = ConstantGravity{{0, 0, -9.81}};
  scene.run.sample_times = {0.0, 5.0};
  add_floor(scene);
  add_sphere(scene, {0, 0, 0.05}, Vec3::Zero());
  const Observations seen = make_closed_form("settling")->observe(scene, {});
  EXPECT_NEAR(seen.scalars.at("resting_overlap"), 1.0273e-4, 5e-9);
  EXPECT_NEAR(0.05 - seen.frames.back().position[0].z(), m * 9.81 / k, 1e-17);
}

TEST(Bounce, ApexesFallByTheSquareOfTheRestitutionWhileContactsAreShort) {
  Scene scene = glass_scene({1e9, Restitution{0.8}});
  scene.gravity = ConstantGravity{{0, 0, -9.81}};
  const double height = 0.5, fall = std::sqrt(2.0 * height / 9.81);
  scene.run.sample_times = {0.0, fall * (1.0 + 0.8), fall * (1.0 + 2 * 0.8 + 0.64)};
  scene.run.end = 2.0;
  add_floor(scene);
  add_sphere(scene, {0, 0, 0.05 + height}, Vec3::Zero());
  const auto frames = make_closed_form("bounce")->observe(scene, {}).frames;
  // A contact takes 1e-4 s of a fall of 0.3 s.
  EXPECT_NEAR(frames[1].position[0].z() - 0.05, height * 0.64, 1e-3);
  EXPECT_NEAR(frames[2].position[0].z() - 0.05, height * 0.4096, 1e-3);
}

Scene oblique(const LinearNormal& law) {
  Scene scene = glass_scene(law);
  scene.contacts.set(0, 0, {law, DynamicFriction{0.3}});
  add_floor(scene);
  add_sphere(scene, {0, 0, 0.05}, {3.0, 0, -1.0});
  return scene;
}

TEST(ObliqueCollision, ChangesTheSlipByTheCoulombImpulse) {
  for (const bool clamped : {false, true}) {
    const LinearNormal law{k, Restitution{0.8}, clamped};
    const Observations seen = make_closed_form("oblique_collision")->observe(oblique(law), {});
    const double change = seen.scalars.at("tangential_velocity_change");
    const double expected = clamped ? 0.3 * 1.8 : 0.3 * (1.0 + 2.0 * 0.80810 - 0.8);
    EXPECT_NEAR(change, expected, clamped ? 1e-13 : 1e-5);  // 0.80810 has five digits
    EXPECT_NEAR(3.0 - seen.frames.back().velocity[0].x(), change, 1e-14);
    EXPECT_NEAR(seen.frames.back().velocity[0].z(), 0.8, 1e-13);
  }
}

TEST(ObliqueCollision, OfAPairIsRefusedWhereItTurns) {
  Scene scene = glass_scene();
  scene.contacts.set(0, 0, {LinearNormal{k, Restitution{0.8}, true}, DynamicFriction{0.3}});
  add_sphere(scene, {0, 0, 0}, Vec3::Zero());
  add_sphere(scene, {0, 0, 0.1}, {3.0, 0, -1.0});
  const auto form = make_closed_form("oblique_collision");
  EXPECT_NE(form->supports(scene, {}).because.find("turns"), std::string::npos);
  scene.contacts.set(0, 0, {LinearNormal{1e10, Restitution{0.8}, true}, DynamicFriction{0.3}});
  ASSERT_TRUE(form->supports(scene, {}));
  EXPECT_NEAR(form->observe(scene, {}).scalars.at("tangential_velocity_change"), 0.3 * 1.8, 1e-13);
}

/// Two free spheres meet at 45 degrees to their line of centres.
Scene oblique_pair(double stiffness) {
  const LinearNormal law{stiffness, Restitution{0.8}};
  Scene scene = glass_scene(law);
  scene.contacts.set(0, 0, {law, DynamicFriction{0.1}});
  add_sphere(scene, Vec3::Zero(), Vec3::Zero());
  add_sphere(scene, {0, 0, 0.1 + 1e-9}, {1.0, 0, -1.0});
  scene.run.sample_times = {0.0, 3.0 * shortest_contact(scene)->duration};
  return scene;
}

/// Relative error of the pair's slip change at this stiffness, against the integration that turns.
double oblique_pair_error(double stiffness) {
  const Scene scene = oblique_pair(stiffness);
  const auto form = make_closed_form("oblique_collision")->observe(scene, {});
  const double step = shortest_contact(scene)->duration / 64.0;
  const auto exact = exact::World(scene).integrate(scene.run.sample_times, step);
  const auto slip = static_cast<double>(exact.back()[9] - exact.back()[6]);
  return std::abs((1.0 - slip) / form.scalars.at("tangential_velocity_change") - 1.0);
}

TEST(ObliqueCollision, OfAPairIsTheStiffLimitOfOneThatTurns) {
  // A turn θ mixes the normal speed into the slip: θ/(2 μ) of it, and θ falls as 1/sqrt(k).
  double last = 1.0;
  for (double stiffness : {1e8, 1e10, 1e12}) {
    const double turn = shortest_contact(oblique_pair(stiffness))->duration / 0.1;
    const double error = oblique_pair_error(stiffness);
    EXPECT_LT(error, 10.0 * turn) << stiffness;
    EXPECT_NEAR(last / error, 10.0, last == 1.0 ? 1e9 : 0.5) << stiffness;
    last = error;
  }
}

TEST(Sliding, CreepsWhereTheStaticBranchIsSmaller) {
  Scene scene = glass_scene();
  scene.contacts.set(0, 0, {LinearNormal{k, Restitution{0.8}}, CollisionTimeFriction{0.6, 1e5}});
  scene.gravity = ConstantGravity{{0, 0, -9.81}};
  scene.run.sample_times = {10.0};
  add_floor(scene);
  add_sphere(scene, {0, 0, 0.05 - m * 9.81 / k}, {1.0, 0, 0});
  const Observations seen = make_closed_form("sliding")->observe(scene, {});
  const double viscosity = 1e5 * std::numbers::pi * std::sqrt(m / k), crossover = 0.6 * m * 9.81 / viscosity;
  const double distance = (1.0 - crossover * crossover) / (2 * 0.6 * 9.81) + crossover * m / viscosity;
  EXPECT_FALSE(seen.scalars.contains("stop_time"));
  EXPECT_NEAR(seen.scalars.at("stop_distance"), distance, 1e-15);
  EXPECT_NEAR(seen.frames.back().position[0].x(), distance, 1e-15);
}

TEST(Dimensionless, StokesNumberIsRelaxationTimeOverTheFlowsTime) {
  EXPECT_NEAR(stokes_number(10.0, 0.1, 1.93e-3, 2.0, 0.5), 0.1 / (18 * 1.93e-3) * 4.0, 1e-14);
}

}  // namespace
}  // namespace grainproof::analytic
