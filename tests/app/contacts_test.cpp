// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/contacts.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/app/scenes.hpp"

namespace grainproof::testing {
namespace {

report::ContactCount counted(const Scene& scene) {
  return report::count_contacts(scene, frame_of(scene));
}

TEST(ContactCount, CountsOverlappingBodiesOnly) {
  EXPECT_EQ(counted(spheres_at({{5, 5, 5}, {5.99, 5, 5}, {7, 5, 5}})).pairs, 1);
  EXPECT_EQ(counted(spheres_at({{5, 5, 5}, {6, 5, 5}})).pairs, 0);
}

TEST(ContactCount, SeesAcrossPeriodicFaces) {
  EXPECT_EQ(counted(spheres_at({{0.1, 0.1, 0.1}, {9.9, 9.9, 9.9}}, Boundary::periodic)).pairs, 1);
  EXPECT_EQ(counted(spheres_at({{0.1, 0.1, 0.1}, {9.9, 9.9, 9.9}}, Boundary::open)).pairs, 0);
}

TEST(ContactCount, CountsWallsOfBothKinds) {
  Scene scene = spheres_at({{5, 5, 0.4}, {5, 5, 0.6}});
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}});
  EXPECT_EQ(counted(scene).walls, 1);
  scene.walls.push_back({"shelf", 0, Rectangle{{4, 4, 1.0}, {6, 6, 1.0}}});
  EXPECT_EQ(counted(scene).walls, 2);
}

TEST(ContactCount, EqualsAllPairsInADensePeriodicGas) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 10.0);
  std::vector<Vec3> places;
  for (int i = 0; i < 600; ++i) {
    const double x = place(random);
    const double y = place(random);
    places.emplace_back(x, y, place(random));
  }
  std::int64_t expected = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 apart = (places[i] - places[j]).cwiseAbs();
      apart = apart.cwiseMin((Vec3::Constant(10.0) - apart));
      expected += apart.norm() < 1.0 ? 1 : 0;
    }
  EXPECT_GT(expected, 500);
  EXPECT_EQ(counted(spheres_at(places, Boundary::periodic)).pairs, expected);
}

}  // namespace
}  // namespace grainproof::testing
