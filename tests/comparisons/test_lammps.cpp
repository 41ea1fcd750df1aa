// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "comparisons/lammps/engine.hpp"
#include "model/errors.hpp"
#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {
namespace {

TEST(LammpsSupport, ProgramThatIsNotInstalledIsNamed) {
  LammpsEngine missing({"no-such-lmp", 1});
  const Support support = missing.supports(collision_with_fixed(10.0, 0.5), {});
  EXPECT_FALSE(support.yes);
  EXPECT_NE(support.because.find("not installed"), std::string::npos);
}

TEST(LammpsErrors, EndOfTheLogIsInTheMessage) {
  Scene scene = collision_with_fixed(10.0, 0.5);
  scene.materials[0].density = -1.0;  // the reader refuses this; LAMMPS does too
  try {
    LammpsEngine().observe(scene, {});
    FAIL();
  } catch (const EngineFailed& failure) {
    EXPECT_NE(std::string(failure.what()).find("ERROR"), std::string::npos) << failure.what();
  }
}

TEST(LammpsSupport, HertzIsElasticOnlyAndWallsHaveNoEdges) {
  const LammpsEngine lammps;
  Scene scene = collision_with_fixed(10.0, 0.5);
  scene.walls = {{"w", 0, Rectangle{Vec3(-0.1, -0.1, -0.5), Vec3(0.1, 0.1, -0.5)}}};
  EXPECT_NE(lammps.supports(scene, {}).because.find("no edges"), std::string::npos);
  scene.walls.clear();
  scene.materials[0].elasticity = Elasticity{1e8, 0.3};
  scene.contacts.set(0, 0, {HertzNormal{Restitution{0.8}}});
  EXPECT_NE(lammps.supports(scene, {}).because.find("only elastic"), std::string::npos);
}

}  // namespace
}  // namespace grainproof::test
