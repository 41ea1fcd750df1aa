// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/quantity.hpp"
#include "tests/comparisons/scenes.hpp"

/// Quantities of bodies that turn.
namespace grainproof::test {
namespace {

Measured error(const char* name, const Scene& scene, const Observations& seen, const Observations& exact) {
  return quantity_named(name)->error(scene, seen, exact);
}

Scene flight() {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{0.8}}}, 10.0);
  scene.particles = {particle(1, Vec3::Zero(), Vec3(2.0, 0.0, 0.0))};
  run_for(scene, 1.0, 0.01);
  return scene;
}

Observations telling(const char* name, double value) {
  Observations exact;
  exact.scalars[name] = value;
  return exact;
}

Observations turning(std::vector<Vec3> spins) {
  Observations seen;
  for (std::size_t k = 0; k < spins.size(); ++k)
    seen.frames.push_back({static_cast<std::int64_t>(k) * 50,
                           0.5 * static_cast<double>(k),
                           {Vec3::Zero()},
                           {Vec3(2.0, 0.0, 0.0)},
                           {spins[k]}});
  return seen;
}

TEST(AngularVelocity, ErrorIsRelativeToTheLargestSpinAndPositiveTooFast) {
  const Scene scene = flight();
  const Observations exact = turning({Vec3::Zero(), Vec3(0.0, 0.0, 4.0)});
  const auto off = [&](const Vec3& last) {
    return error("angular_velocity", scene, turning({Vec3::Zero(), last}), exact).value;
  };
  EXPECT_NEAR(off(Vec3(0.0, 0.0, 5.0)), 0.25, 1e-15);
  EXPECT_NEAR(off(Vec3(0.0, 0.0, 3.0)), -0.25, 1e-15);
  EXPECT_NEAR(std::abs(off(Vec3(1.0, 0.0, 4.0))), 0.25, 1e-15);
}

TEST(AngularVelocity, HasSpeedOverRadiusAsItsScaleWhereNothingTurns) {
  const Scene scene = flight();  // radius 0.05 m, 2 m/s: 40 rad/s
  const Observations exact = turning({Vec3::Zero(), Vec3::Zero()});
  EXPECT_NEAR(std::abs(error("angular_velocity", scene, turning({Vec3::Zero(), Vec3(1, 0, 0)}), exact).value),
              1.0 / 40.0, 1e-15);
}

TEST(AngularVelocity, DoesNotExistWithoutRotation) {
  const Scene scene = flight();
  const Observations exact = turning({Vec3::Zero()});
  Observations without = exact;
  without.frames[0].angular_velocity.clear();
  EXPECT_FALSE(error("angular_velocity", scene, without, exact).exists());
  EXPECT_FALSE(error("angular_velocity", scene, exact, without).exists());
}

TEST(KineticEnergy, OfRotationCountsWithTwoFifthsOfMassTimesRadiusSquared) {
  const Scene scene = flight();
  const Observations exact = turning({Vec3::Zero()});
  // ½ (2/5) r² ω² = ½ v² / 4 for r = 0.05, v = 2, ω = 0.5 v/r sqrt(5/2)
  const Observations faster = turning({Vec3(0.0, 20.0 * std::sqrt(2.5), 0.0)});
  EXPECT_NEAR(error("kinetic_energy", scene, faster, exact).value, 0.25, 1e-14);
}

TEST(TangentialVelocityChange, IsThatOfTheSurfacesWhereBodiesTurn) {
  Scene wall = flight();  // the wall is on the right, n = −x, radius 0.05
  wall.walls = {{"w", 0, Plane{Vec3(1.0, 0, 0), Vec3(-1, 0, 0)}}};
  Observations seen;
  // Rolling upwards along a wall on the right is ω = −z: the surface there moves down against the centre.
  seen.frames = {{0, 0.0, {Vec3::Zero()}, {Vec3(3, 1, 0)}, {Vec3::Zero()}},
                 {1, 1.0, {Vec3(0.5, 0.3, 0)}, {Vec3(-1.5, 0.75, 0)}, {Vec3(0, 0, -15.0)}}};
  EXPECT_NEAR(
      error("tangential_velocity_change", wall, seen, telling("tangential_velocity_change", 1.0)).value, 0.0,
      1e-15);
  EXPECT_NEAR(error("restitution", wall, seen, telling("restitution", 0.5)).value, 0.0, 1e-15);
}

}  // namespace
}  // namespace grainproof::test
