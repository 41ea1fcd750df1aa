// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/laws/drag.hpp"
#include "reference_cpu/laws/flow.hpp"
#include "reference_cpu/laws/gravity.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

using reference::fluid_velocity;
using reference::GravityField;

// θ = (t/2 s)²: half a turn at t = 2 sqrt(π), where gravity points up; a quarter turn points along x.
TEST(Gravity, RotatingTurnsWithTheSquareOfTime) {
  const RotatingGravity rotating{9.81, 2.0};
  const double pi = std::numbers::pi;
  const auto at = [&](double time) { return GravityField(rotating, time).at(Vec3(1.0, 2.0, 3.0)); };
  EXPECT_LE((at(0.0) - Vec3(0.0, -9.81, 0.0)).norm(), 1e-14);
  EXPECT_LE((at(2.0 * std::sqrt(0.5 * pi)) - Vec3(9.81, 0.0, 0.0)).norm(), 1e-13);
  EXPECT_LE((at(2.0 * std::sqrt(pi)) - Vec3(0.0, 9.81, 0.0)).norm(), 1e-13);
}

TEST(Gravity, CentralHasOneMagnitudeTowardsItsCentreAndNoneThere) {
  const GravityField field(CentralGravity{2.0, {1.0, 0.0, 0.0}}, 0.0);
  EXPECT_LE((field.at({1.0, 3.0, 4.0}) - Vec3(0.0, -1.2, -1.6)).norm(), 1e-15);
  EXPECT_EQ(field.at({1.0, 0.0, 0.0}), Vec3::Zero());
}

TEST(Gravity, ActsOnMovingParticlesOnly) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1e-3);
  scene.gravity = ConstantGravity{{0.0, 0.0, -9.81}};
  add_particle(scene, 0.1, {0.0, 0.0, 0.0}).fixed = true;
  add_particle(scene, 0.1, {1.0, 0.0, 0.0});
  EXPECT_EQ(force_on(scene, 0), Vec3::Zero());
  EXPECT_NEAR(force_on(scene, 1).z(), -9.81 * sphere_mass(0.1), 1e-14);
}

const TaylorGreenFlow vortices{1.93e-3, 0.7, 3.0};

// Andrews 6.1-6.3 at a x = 0, a y = π/2 · ⅓, a z = π/4, by hand: cos(ax + π/2) = −sin(ax), sin(ax + π/2) =
// cos(ax).
TEST(Flow, TaylorGreenIsThePrintedField) {
  const double pi = std::numbers::pi;
  const Vec3 at = Vec3(pi / 4.0, pi / 6.0, pi / 3.0) / 3.0;
  const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0);
  const Vec3 expected = 0.7 * Vec3(-root2 / 2.0 * root3 / 2.0 * 0.5, -root2 / 2.0 * 0.5 * 0.5,
                                   2.0 * root2 / 2.0 * root3 / 2.0 * root3 / 2.0);
  EXPECT_LE((fluid_velocity(vortices, at) - expected).norm(), 1e-15);
}

// E17. Central differences over 2e-5 m: truncation a³ A h²/6 = 3e-10, round-off 1e-16/1e-5 = 1e-11; slopes
// are of order A a = 2.
TEST(Flow, TaylorGreenHasNoDivergence) {
  Random random(11);
  const double half = 1e-5;
  for (int sample = 0; sample < 100; ++sample) {
    const Vec3 at = random.in_box(Vec3::Constant(-2.0), Vec3::Constant(2.0));
    double divergence = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 offset = half * Vec3::Unit(axis);
      divergence += (fluid_velocity(vortices, at + offset) - fluid_velocity(vortices, at - offset))[axis];
    }
    EXPECT_LE(std::abs(divergence / (2.0 * half)), 1e-8);
  }
}

// E10: the mean over a period of the printed field; 0.7839 in the source. The midpoint rule over 128³
// points is good to 4e-6 here, as the speed has kinks where it vanishes, and the figure to 5e-6.
TEST(Flow, TaylorGreenMeanSpeedIs077994OfItsAmplitude) {
  constexpr int points = 128;
  const double spacing = 2.0 * std::numbers::pi / points;
  double sum = 0.0;
  for (int x = 0; x < points; ++x)
    for (int y = 0; y < points; ++y)
      for (int z = 0; z < points; ++z)
        sum +=
            fluid_velocity(TaylorGreenFlow{1.0, 1.0, 1.0}, spacing * Vec3(x + 0.5, y + 0.5, z + 0.5)).norm();
  EXPECT_NEAR(sum / (points * points * points), 0.77994, 1e-5);
}

// Andrews 2.11 by hand: ρ 10, d 0.1, μ 0.00193: τ = 0.1/0.03474 = 2.878526 s.
TEST(Drag, PullsTowardsTheFluidOverTheResponseTime) {
  EXPECT_NEAR(1.0 / reference::drag_rate(10.0, 0.1, 0.00193), 2.8785262, 1e-7);
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1e-3);
  scene.materials[0].density = 10.0;
  scene.flow = UniformFlow{0.00193, {1.0, 0.0, 0.0}};
  add_particle(scene, 0.1, Vec3::Zero(), {0.25, 0.5, 0.0});
  const Vec3 expected = sphere_mass(0.1, 10.0) / 2.8785262 * Vec3(0.75, -0.5, 0.0);
  EXPECT_LE((force_on(scene, 0) - expected).norm(), 1e-10);
}

}  // namespace
}  // namespace grainproof::testing
