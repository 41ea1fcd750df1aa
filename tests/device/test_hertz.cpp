// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Chung and Ooi 2011, tests 1 to 3, and the effective moduli.
#include <cmath>

#include "device_fixture.hpp"
#include "model/errors.hpp"
#include "opencl/pair_laws.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Impact {
  const char* name;
  Elasticity elasticity;
  double density, radius, speed;  ///< speed of each sphere, or onto the plane
  bool on_plane;
  double overlap, force, duration;  ///< as printed by Chung and Ooi
};

const Impact impacts[] = {
    {"glass", {48e9, 0.20}, 2800, 0.01, 10.0, false, 274.11e-6, 10696.9, 40.34e-6},
    {"limestone", {20e9, 0.25}, 2500, 0.01, 10.0, false, 368.30e-6, 7108.2, 54.20e-6},
    {"aluminium_alloy", {70e9, 0.30}, 2699, 0.1, 0.2, true, 49.717e-6, 11369.9, 731.66e-6},
    {"magnesium_alloy", {40e9, 0.35}, 1800, 0.1, 0.2, true, 52.123e-6, 7232.7, 767.07e-6},
};

/// A plane of Chung and Ooi is rigid. Two of the sphere's own material share the compliance alike, so it is
/// a second material that hardly yields.
Scene impact_scene(const Impact& impact, double restitution = 1.0) {
  Scene scene = empty_scene(1.0);
  scene.materials = {{"sphere", impact.density, impact.elasticity},
                     {"plane", 1.0, Elasticity{impact.elasticity.youngs_modulus * 1e9, 0.0}}};
  scene.contacts = ContactTable(2);
  for (std::size_t other : {0u, 1u})
    scene.contacts.set(0, other, {HertzNormal{Restitution{restitution}}, Frictionless{}, NoCohesion{}});
  const double d = 2 * impact.radius, h = impact.duration / 200, gap = 0.5 * h * impact.speed;
  scene.domain = {Vec3::Constant(-2 * d), Vec3::Constant(2 * d), {}};
  if (impact.on_plane) {
    scene.walls = {{"plane", 1, Plane{Vec3::Zero(), Vec3::UnitZ()}}};
    scene.particles = {sphere(0, {0, 0, impact.radius + gap}, {0, 0, -impact.speed}, d)};
  } else {
    scene.particles = {sphere(0, {0, 0, impact.radius + gap}, {0, 0, -impact.speed}, d),
                       sphere(1, {0, 0, -impact.radius - gap}, {0, 0, impact.speed}, d)};
  }
  scene.run.step = h;
  scene.run.end = 210 * h;
  scene.run.sample_times = {0.0, scene.run.end};
  return scene;
}

struct Seen {
  double overlap = 0.0, force = 0.0, duration = 0.0, rebound = 0.0;
};

double overlap_in(const Scene& scene, const Frame& frame) {
  const double r = scene.particles[0].diameter / 2;
  return scene.walls.empty() ? 2 * r - (frame.position[0] - frame.position[1]).norm()
                             : r - frame.position[0].z();
}

/// Where a straight line through two samples crosses zero.
double crossing(const Frame& a, const Frame& b, double before, double after) {
  return a.time + (b.time - a.time) * before / (before - after);
}

/// Peak by a parabola through the three deepest frames; ends where the free flights meet zero overlap.
Seen measured(const Scene& scene, Precision precision) {
  Request every;
  every.every_step = true;
  const auto frames = observed(options_for(precision), scene, every).frames;
  Seen seen;
  double onset = 0.0;
  for (std::size_t k = 1; k + 1 < frames.size(); ++k) {
    const double a = overlap_in(scene, frames[k - 1]), b = overlap_in(scene, frames[k]),
                 c = overlap_in(scene, frames[k + 1]);
    if (a <= 0 && b > 0) onset = crossing(frames[k - 1], frames[k], a, b);
    if (b > 0 && c <= 0) seen.duration = crossing(frames[k], frames[k + 1], b, c) - onset;
    if (b > a && b >= c) seen.overlap = b + (c - a) * (c - a) / (8 * (2 * b - a - c));
  }
  const double m = mass_of(scene.particles[0], scene);
  for (std::size_t k = 1; k < frames.size(); ++k)
    seen.force =
        std::max(seen.force, m * (frames[k].velocity[0] - frames[k - 1].velocity[0]).z() / scene.run.step);
  seen.rebound = frames.back().velocity[0].z() / scene.particles[0].velocity.z();
  return seen;
}

class Hertz : public ::testing::TestWithParam<std::tuple<Precision, Impact>> {};

/// Printed with five figures, so half a unit of the last of them is part of the bar.
TEST_P(Hertz, PeaksAndLastsAsChungAndOoiAtTwoHundredSteps) {
  const auto& [precision, impact] = GetParam();
  const Seen seen = measured(impact_scene(impact), precision);
  // Single resolves a height by a fraction of 2^-30 of the box: its own floor is in the velocity, 2^-24 a
  // kick.
  EXPECT_LE(std::abs(seen.overlap / impact.overlap - 1), 5e-4) << seen.overlap;
  EXPECT_LE(std::abs(seen.duration / impact.duration - 1), 5e-4) << seen.duration;
  EXPECT_LE(std::abs(seen.force / impact.force - 1), 5e-4) << seen.force;
  EXPECT_LE(std::abs(seen.rebound + 1), 5e-4);
}

/// Tsuji's dashpot gives the same restitution at any speed; the half-step velocity in it is first order.
TEST_P(Hertz, LeavesWithTheRestitutionAskedFor) {
  const auto& [precision, impact] = GetParam();
  for (const double e : {0.4, 0.8}) {
    Scene scene = impact_scene(impact, e);
    scene.run.step /= 8;
    scene.run.end *= 1.5;
    scene.run.sample_times = {0.0, scene.run.end};
    EXPECT_LE(std::abs(-measured(scene, precision).rebound - e), 2e-3) << e;
  }
}

INSTANTIATE_TEST_SUITE_P(
    ChungOoi, Hertz, ::testing::Combine(::testing::ValuesIn(every_precision), ::testing::ValuesIn(impacts)),
    [](const ::testing::TestParamInfo<std::tuple<Precision, Impact>>& param) {
      return std::string(name_of(std::get<0>(param.param))) + "_" + std::get<1>(param.param).name;
    });

TEST(HertzCoefficients, ModuliAndTangentialLawAreMindlins) {
  Scene scene = impact_scene(impacts[0]);
  scene.contacts.set(0, 0, {HertzNormal{Restitution{0.5}}, HistoryFriction{0.3, 0.0, 1.0}, NoCohesion{}});
  const double e = 48e9, nu = 0.2, g = e / (2 * (1 + nu));
  const EffectiveModuli moduli = effective_moduli(scene.materials[0], scene.materials[0]);
  EXPECT_DOUBLE_EQ(moduli.youngs, e / (2 * (1 - nu * nu)));
  EXPECT_DOUBLE_EQ(moduli.shear, g / (2 * (2 - nu)));
  const PairCoefficients c = coefficients_of(scene, 0, 0);
  const double beta = std::log(2.0) / std::hypot(std::log(2.0), M_PI);
  EXPECT_DOUBLE_EQ(c.stiffness, 4.0 / 3.0 * moduli.youngs);
  EXPECT_DOUBLE_EQ(c.damping.at(2.0), 2 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(2.0 * 2 * moduli.youngs));
  EXPECT_DOUBLE_EQ(c.history.stiffness, 8 * moduli.shear);
  EXPECT_DOUBLE_EQ(c.history.damping.at(2.0),
                   2 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(2.0 * 8 * moduli.shear));
}

TEST(HertzCoefficients, ADampingRatioIsAShareOfTheCriticalDashpotOfTheMoment) {
  Scene scene = impact_scene(impacts[0]);
  scene.contacts.set(0, 0, {HertzNormal{DampingRatio{0.3}}, HistoryFriction{0.3, 0.0, 0.5}, NoCohesion{}});
  const EffectiveModuli moduli = effective_moduli(scene.materials[0], scene.materials[0]);
  const PairCoefficients c = coefficients_of(scene, 0, 0);
  EXPECT_DOUBLE_EQ(c.damping.at(2.0), 2 * 0.3 * std::sqrt(2.0 * 2 * moduli.youngs));
  EXPECT_DOUBLE_EQ(c.history.damping.at(2.0), 0.5 * 2 * 0.3 * std::sqrt(2.0 * 8 * moduli.shear));
  scene.contacts.set(0, 0, {LinearNormal{stiffness, DampingRatio{0.3}}, Frictionless{}, NoCohesion{}});
  EXPECT_DOUBLE_EQ(coefficients_of(scene, 0, 0).damping.at(2.0), 2 * 0.3 * std::sqrt(2.0 * stiffness));
}

TEST(HertzCoefficients, RefusesWhatItCannotTell) {
  const OpenClEngine engine(options_for(Precision::double_precision));
  Scene scene = impact_scene(impacts[0]);
  EXPECT_TRUE(engine.supports(scene, {}));
  scene.contacts.set(0, 0, {HertzNormal{Damping{1.0}}, Frictionless{}, NoCohesion{}});
  EXPECT_NE(engine.supports(scene, {}).because.find("restitution"), std::string::npos);
  scene.contacts.set(0, 0, {HertzNormal{Restitution{0.0}}, Frictionless{}, NoCohesion{}});
  EXPECT_NE(engine.supports(scene, {}).because.find("never ends"), std::string::npos);
  scene.contacts.set(0, 0, {HertzNormal{Restitution{1.0}}, CollisionTimeFriction{0.3, 1e5}, NoCohesion{}});
  EXPECT_NE(engine.supports(scene, {}).because.find("collision time"), std::string::npos);
  scene = impact_scene(impacts[0]);
  scene.materials[0].elasticity.reset();
  EXPECT_NE(engine.supports(scene, {}).because.find("sphere has no elasticity"), std::string::npos);
}

}  // namespace
}  // namespace grainproof::opencl::testing
