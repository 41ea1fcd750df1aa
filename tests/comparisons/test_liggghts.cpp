// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "comparisons/liggghts/engine.hpp"
#include "comparisons/metrics/bed.hpp"
#include "model/errors.hpp"
#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {
namespace {

Scene thousand_falling() {
  Scene scene = scene_of({LinearNormal{1e4, Restitution{0.5}}});
  scene.domain = {Vec3::Zero(), Vec3(0.1, 0.1, 0.4), {Boundary::wall, Boundary::wall, Boundary::wall}};
  for (int axis = 0; axis < 3; ++axis) {
    scene.walls.push_back({"lower", 0, Plane{scene.domain.lower, Vec3::Unit(axis)}});
    scene.walls.push_back({"upper", 0, Plane{scene.domain.upper, -Vec3::Unit(axis)}});
  }
  scene.gravity = ConstantGravity{Vec3(0.0, 0.0, -9.81)};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shake(-1e-3, 1e-3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 place(0.006 + 0.012 * (i % 8), 0.006 + 0.012 * (i / 8 % 8), 0.01 + 0.0125 * (i / 64));
    scene.particles.push_back(
        particle(i + 1, place + Vec3(shake(random), shake(random), 0.0), Vec3::Zero(), false, 0.01));
  }
  run_for(scene, 0.8, 3.5e-5);  // 20 steps a contact
  return scene;
}

TEST(LiggghtsBox, ThousandSpheresComeToRest) {
  const Scene scene = thousand_falling();
  const Observations seen = LiggghtsEngine().observe(scene, {});
  ASSERT_EQ(seen.outcome.status, Outcome::Status::completed) << seen.outcome.reason;
  RecordProperty("wall_s", std::to_string(seen.wall_s));
  const double solid = 1000 * std::numbers::pi * 1e-6 / 6.0 / 0.01;  // height of the same matter without gaps
  EXPECT_GT(bed_height(scene, seen).value, solid / 0.70);            // nothing random packs denser
  EXPECT_LT(bed_height(scene, seen).value, solid / 0.50);
  EXPECT_GT(contact_number(scene, seen).value, 3.5);  // frictionless packings have about 6, fewer at walls
  EXPECT_LT(contact_number(scene, seen).value, 7.0);
  double fastest = 0.0;
  for (const Vec3& v : seen.frames.back().velocity) fastest = std::max(fastest, v.norm());
  EXPECT_LT(fastest, 0.1);
}

TEST(LiggghtsSupport, ProgramThatIsNotInstalledIsNamed) {
  LiggghtsEngine missing({"no-such-liggghts", 1});
  const Support support = missing.supports(collision_with_fixed(10.0, 0.5), {});
  EXPECT_FALSE(support.yes);
  EXPECT_NE(support.because.find("not installed"), std::string::npos);
}

TEST(LiggghtsErrors, EndOfTheLogIsInTheMessage) {
  Scene scene = collision_with_fixed(10.0, 0.5);
  scene.particles[1].diameter = -0.1;  // the reader refuses this; LIGGGHTS does too
  try {
    LiggghtsEngine().observe(scene, {});
    FAIL();
  } catch (const EngineFailed& failure) {
    EXPECT_NE(std::string(failure.what()).find("ERROR"), std::string::npos) << failure.what();
  }
}

}  // namespace
}  // namespace grainproof::test
